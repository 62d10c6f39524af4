//! Operations and scripts on meshes: the machine, against literal readings and tables.

mod engines;
mod everywhere;
mod guard;
mod inherited;
mod lessons;
mod live;
mod local_ops;
mod machine;
mod marks;
mod masks;
mod planar_actions;
mod programs;
mod schemes;
mod script;
mod sequences;
mod session;
mod steps;
mod threads;
mod workbench;
