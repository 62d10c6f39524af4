//! Small mutations of an op that may or may not make it unsound.
//!
//! Each works on the data of a rule: names and statements are swapped, dropped, moved, copied. Some
//! mutations are large on purpose, and some are meant to keep the op sound: they state more facts
//! that hold, so that there are accepted ops of all shapes.

use hedgerow::diagram::{
    Alias, Edge, Kind, LoopItem, LoopKind, Name, NameId, Op, Ref, Role, Rule, Side, Spoke, Star,
    Type,
};
use hedgerow::mesh::VertexId;
use hedgerow::source::Span;

use super::completion::complete;
use super::random::Random;

/// Mutates an op of one rule once; `None` if the chosen mutation does not apply.
pub fn mutate(op: &mut Op, random: &mut Random) -> Option<()> {
    let mut mutation = Mutation { rule: op.rules.first_mut()?, random };
    match mutation.random.below(40) {
        0 => mutation.swap_names()?,
        1 => mutation.swap_mentions()?,
        2..=4 => mutation.relabel()?,
        5..=6 => mutation.drop_statement()?,
        7 => mutation.exchange_twins()?,
        8..=10 => mutation.edit_star()?,
        11 => mutation.move_spoke()?,
        12..=13 => mutation.change_loop_kind()?,
        14..=15 => mutation.move_item()?,
        16 => mutation.drop_from_list()?,
        17 => mutation.erase_more()?,
        18..=19 => mutation.exchange_path_and_halfedge()?,
        20 => mutation.copy_statement()?,
        21..=22 => mutation.draw_a_twin()?,
        23..=26 => mutation.draw_a_star()?,
        27 => mutation.merge_names()?,
        28 => mutation.merge_vertices()?,
        29 => mutation.drop_item()?,
        30 => mutation.lengthen()?,
        31 => mutation.any_loops()?,
        32 => mutation.rotate_loop()?,
        33..=38 => mutation.let_names_be_one()?,
        _ => change_parameter(op, random)?,
    }
    let rule = op.rules.first_mut()?;
    for side in [&mut rule.before, &mut rule.after] {
        side.loops.retain(|orbit| !orbit.items.is_empty());
        side.stars.retain(|star| !star.spokes.is_empty());
        for orbit in &mut side.loops {
            orbit.end = orbit.items[0].from;
        }
    }
    tidy(rule);
    Some(())
}

/// Removes from the lists the names that no longer agree with the statements.
fn tidy(rule: &mut Rule) {
    let before = mentioned(&rule.before);
    let after = mentioned(&rule.after);
    rule.created.retain(|new| after.contains(&new.name) && !before.contains(&new.name));
    let created: Vec<_> = rule.created.iter().map(|new| new.name).collect();
    rule.erased.retain(|old| {
        (before.contains(&old.name) || after.contains(&old.name)) && !created.contains(&old.name)
    });
    for alias in &mut rule.aliases {
        alias.names.retain(|name| before.contains(&name.name));
    }
    rule.aliases.retain(|alias| alias.names.len() > 1);
    let erased: Vec<_> = rule.erased.iter().map(|old| old.name).collect();
    rule.assignments.retain(|set| {
        let name = set.target.name;
        (before.contains(&name) || after.contains(&name)) && !erased.contains(&name)
    });
}

fn mentioned(side: &Side) -> Vec<NameId> {
    let mut side = side.clone();
    refs(&mut side).into_iter().map(|mention| mention.name).collect()
}

/// All mentions on a side, except the ends of loops, which repeat their beginnings.
pub fn refs(side: &mut Side) -> Vec<&mut Ref> {
    let mut refs = Vec::new();
    for orbit in &mut side.loops {
        refs.push(&mut orbit.face);
        for item in &mut orbit.items {
            refs.push(&mut item.from);
            refs.push(&mut item.item);
        }
    }
    for edge in &mut side.edges {
        refs.push(&mut edge.edge);
        refs.extend(edge.halfedges.iter_mut());
    }
    for star in &mut side.stars {
        refs.push(&mut star.vertex);
        for spoke in &mut star.spokes {
            if let Spoke::Halfedge(name) | Spoke::Fan(name) = spoke {
                refs.push(name);
            }
        }
    }
    refs
}

fn change_parameter(op: &mut Op, random: &mut Random) -> Option<()> {
    let rule = op.rules.first_mut()?;
    let at = random.below(op.params.len());
    let kinds = [
        (Kind::Vertex, Type::Vertex),
        (Kind::Halfedge, Type::Halfedge),
        (Kind::Edge, Type::Edge),
        (Kind::Face, Type::Face),
    ];
    let &(kind, ty) = random.pick(&kinds)?;
    let drawn = mentioned(&rule.before);
    let names: Vec<_> = rule.names_of(kind).filter(|name| drawn.contains(name)).collect();
    let &name = random.pick(&names)?;
    if rule.params.contains(&Some(name)) {
        return None;
    }
    op.params[at].ty = ty;
    op.params[at].name = rule.name(name).text.clone();
    rule.params[at] = Some(name);
    Some(())
}

struct Mutation<'a> {
    rule: &'a mut Rule,
    random: &'a mut Random,
}

impl Mutation<'_> {
    /// A random side: `after` twice as often as `before`.
    fn side(&mut self) -> &mut Side {
        match self.random.once_in(3) {
            true => &mut self.rule.before,
            false => &mut self.rule.after,
        }
    }

    fn here(&self, name: NameId) -> Ref {
        Ref::plain(name, self.span())
    }

    fn span(&self) -> Span {
        self.rule.span
    }

    fn fresh(&mut self, kind: Kind) -> NameId {
        let number = self.rule.names.len();
        let letter = match kind {
            Kind::Vertex => "u",
            Kind::Halfedge => "x",
            Kind::Edge => "k",
            Kind::Face => "l",
            Kind::Path => "W",
            Kind::Fan => "Z",
        };
        let text = format!("{letter}{number}x");
        self.rule.names.push(Name {
            text,
            kind,
            named: true,
            role: Role::Single,
            span: self.rule.span,
        });
        NameId(number as u32)
    }

    /// Two random names of one kind.
    fn two_names(&mut self) -> Option<[NameId; 2]> {
        let first = NameId(self.random.below(self.rule.names.len()) as u32);
        let kind = self.rule.kind(first);
        let others: Vec<_> = self.rule.names_of(kind).filter(|&name| name != first).collect();
        Some([first, *self.random.pick(&others)?])
    }

    /// Adds an alias of two to four names of one kind, usually vertices.
    fn let_names_be_one(&mut self) -> Option<()> {
        if self.rule.cycle.is_some() {
            return None;
        }
        let kind = match self.random.below(8) {
            0 => Kind::Halfedge,
            1 => Kind::Face,
            _ => Kind::Vertex,
        };
        let drawn = mentioned(&self.rule.before);
        let mut names: Vec<_> =
            self.rule.names_of(kind).filter(|name| drawn.contains(name)).collect();
        self.random.shuffle(&mut names);
        names.truncate(2 + self.random.below(3).min(self.random.below(3)));
        let names: Vec<_> = names.into_iter().map(|name| self.here(name)).collect();
        let span = self.span();
        (names.len() > 1).then(|| self.rule.aliases.push(Alias { names, span }))
    }

    fn swap_names(&mut self) -> Option<()> {
        let [first, second] = self.two_names()?;
        for mention in refs(self.side()) {
            if mention.name == first {
                mention.name = second;
            } else if mention.name == second {
                mention.name = first;
            }
        }
        Some(())
    }

    /// Swaps two mentions on a side, of different names of one kind.
    fn swap_mentions(&mut self) -> Option<()> {
        let [first, second] = self.two_names()?;
        let mut random = self.random.clone();
        let mut refs = refs(self.side());
        let places = |refs: &[&mut Ref], name: NameId| -> Vec<usize> {
            (0..refs.len()).filter(|&at| refs[at].name == name).collect()
        };
        let one = *random.pick(&places(&refs, first))?;
        let other = *random.pick(&places(&refs, second))?;
        refs[one].name = second;
        refs[other].name = first;
        *self.random = random;
        Some(())
    }

    fn relabel(&mut self) -> Option<()> {
        let [first, second] = self.two_names()?;
        let mut random = self.random.clone();
        let refs = refs(self.side());
        let mut places: Vec<_> = refs.into_iter().filter(|mention| mention.name == first).collect();
        let count = places.len();
        if count == 0 {
            return None;
        }
        places[random.below(count)].name = second;
        *self.random = random;
        Some(())
    }

    fn drop_statement(&mut self) -> Option<()> {
        let pick = self.random.next() as usize;
        let side = self.side();
        let [loops, edges, stars] = [side.loops.len(), side.edges.len(), side.stars.len()];
        let all = loops + edges + stars;
        if all == 0 {
            return None;
        }
        let at = pick % all;
        if at < loops {
            side.loops.remove(at);
        } else if at < loops + edges {
            side.edges.remove(at - loops);
        } else {
            side.stars.remove(at - loops - edges);
        }
        Some(())
    }

    fn exchange_twins(&mut self) -> Option<()> {
        let picks = [0; 4].map(|_| self.random.next() as usize);
        let edges = &mut self.side().edges;
        if edges.len() < 2 {
            return None;
        }
        let one = picks[0] % edges.len();
        let other = (one + 1 + picks[1] % (edges.len() - 1)) % edges.len();
        let [x, y] = [picks[2] % 2, picks[3] % 2];
        let kept = edges[one].halfedges[x];
        edges[one].halfedges[x] = edges[other].halfedges[y];
        edges[other].halfedges[y] = kept;
        Some(())
    }

    fn edit_star(&mut self) -> Option<()> {
        let span = self.span();
        let fan = self.fresh(Kind::Fan);
        let halfedges: Vec<_> = self.rule.names_of(Kind::Halfedge).collect();
        let half = *self.random.pick(&halfedges)?;
        let mut random = self.random.clone();
        let stars = &mut self.side().stars;
        if stars.is_empty() {
            return None;
        }
        let at = random.below(stars.len());
        let spokes = &mut stars[at].spokes;
        let place = random.below(spokes.len());
        match random.below(8) {
            0 => {
                spokes.remove(place); // swallowed
            }
            1 => {
                let other = random.below(spokes.len());
                spokes.swap(place, other);
            }
            2 => spokes.insert(place, Spoke::Rest(span)),
            3 => spokes.insert(place, Spoke::Fan(Ref::plain(fan, span))),
            4 => {
                let is_fan = |spoke: &Spoke| !matches!(spoke, Spoke::Halfedge(_));
                let fan = spokes.iter_mut().find(|spoke| is_fan(spoke))?;
                *fan = Spoke::Rest(span);
            }
            5 => {
                let is_fan = |spoke: &Spoke| !matches!(spoke, Spoke::Halfedge(_));
                let fan = spokes.iter().position(is_fan)?;
                spokes.remove(fan);
            }
            6 => spokes.insert(place, Spoke::Halfedge(Ref::plain(half, span))),
            _ => spokes.rotate_left(place),
        }
        *self.random = random;
        Some(())
    }

    fn move_spoke(&mut self) -> Option<()> {
        let mut random = self.random.clone();
        let stars = &mut self.side().stars;
        if stars.is_empty() {
            return None;
        }
        let from = random.below(stars.len());
        let to = random.below(stars.len());
        let at = random.below(stars[from].spokes.len());
        let spoke = stars[from].spokes.remove(at);
        let place = random.below(stars[to].spokes.len() + 1);
        stars[to].spokes.insert(place, spoke);
        *self.random = random;
        Some(())
    }

    fn change_loop_kind(&mut self) -> Option<()> {
        let kind = *self.random.pick(&[LoopKind::Face, LoopKind::Hole, LoopKind::Any])?;
        let pick = self.random.next() as usize;
        let both = self.random.once_in(2);
        let loops = &mut self.side().loops;
        if loops.is_empty() {
            return None;
        }
        let at = pick % loops.len();
        loops[at].kind = kind;
        let face = loops[at].face.name;
        if both {
            let rule = &mut self.rule;
            let all = rule.before.loops.iter_mut().chain(&mut rule.after.loops);
            all.filter(|orbit| orbit.face.name == face).for_each(|orbit| orbit.kind = kind);
        }
        Some(())
    }

    fn any_loops(&mut self) -> Option<()> {
        for orbit in &mut self.rule.before.loops {
            orbit.kind = LoopKind::Any;
        }
        let drawn = mentioned(&self.rule.before);
        let after = self.rule.after.loops.iter_mut();
        after
            .filter(|orbit| drawn.contains(&orbit.face.name))
            .for_each(|orbit| orbit.kind = LoopKind::Any);
        Some(())
    }

    fn move_item(&mut self) -> Option<()> {
        let picks = [0; 4].map(|_| self.random.next() as usize);
        let loops = &mut self.side().loops;
        if loops.is_empty() {
            return None;
        }
        let from = picks[0] % loops.len();
        let to = picks[1] % loops.len();
        let at = picks[2] % loops[from].items.len();
        let item = loops[from].items.remove(at);
        let place = picks[3] % (loops[to].items.len() + 1);
        loops[to].items.insert(place, item);
        Some(())
    }

    fn drop_item(&mut self) -> Option<()> {
        let picks = [0; 2].map(|_| self.random.next() as usize);
        let loops = &mut self.side().loops;
        if loops.is_empty() {
            return None;
        }
        let from = picks[0] % loops.len();
        let at = picks[1] % loops[from].items.len();
        loops[from].items.remove(at);
        Some(())
    }

    /// Inserts one more item into a loop on both sides, after the same item.
    fn lengthen(&mut self) -> Option<()> {
        let kind = if self.random.once_in(2) { Kind::Path } else { Kind::Halfedge };
        let item = self.fresh(kind);
        let vertex = match self.random.once_in(3) {
            true => {
                let vertices: Vec<_> = self.rule.names_of(Kind::Vertex).collect();
                *self.random.pick(&vertices)?
            }
            false => self.fresh(Kind::Vertex),
        };
        let items: Vec<_> = self
            .rule
            .before
            .loops
            .iter()
            .flat_map(|orbit| orbit.items.iter().map(|item| item.item.name))
            .collect();
        let behind = *self.random.pick(&items)?;
        let (item, vertex) = (self.here(item), self.here(vertex));
        let rule = &mut self.rule;
        for orbit in rule.before.loops.iter_mut().chain(&mut rule.after.loops) {
            if let Some(at) = orbit.items.iter().position(|item| item.item.name == behind) {
                orbit.items.insert(at + 1, LoopItem { from: vertex, item });
            }
        }
        Some(())
    }

    fn rotate_loop(&mut self) -> Option<()> {
        let picks = [0; 2].map(|_| self.random.next() as usize);
        let loops = &mut self.side().loops;
        if loops.is_empty() {
            return None;
        }
        let at = picks[0] % loops.len();
        // The vertices stay, the items move by one.
        let items = &mut loops[at].items;
        let first = items[0].item;
        for place in 1..items.len() {
            items[place - 1].item = items[place].item;
        }
        items.last_mut()?.item = first;
        Some(())
    }

    fn drop_from_list(&mut self) -> Option<()> {
        let pick = self.random.next() as usize;
        let list = match self.random.once_in(2) {
            true => &mut self.rule.created,
            false => &mut self.rule.erased,
        };
        if list.is_empty() {
            return None;
        }
        list.remove(pick % list.len());
        Some(())
    }

    fn erase_more(&mut self) -> Option<()> {
        let name = NameId(self.random.below(self.rule.names.len()) as u32);
        if self.rule.erased.iter().any(|erased| erased.name == name) {
            return None;
        }
        let erased = self.here(name);
        self.rule.erased.push(erased);
        if self.random.once_in(2) {
            // And removes it from `after`.
            let after = &mut self.rule.after;
            after.loops.retain(|orbit| orbit.face.name != name);
            for orbit in &mut after.loops {
                orbit.items.retain(|item| item.item.name != name);
            }
            after.edges.retain(|edge| {
                edge.edge.name != name && edge.halfedges.iter().all(|half| half.name != name)
            });
            after.stars.retain(|star| star.vertex.name != name);
        }
        Some(())
    }

    fn exchange_path_and_halfedge(&mut self) -> Option<()> {
        let items: Vec<_> = self
            .rule
            .before
            .loops
            .iter()
            .flat_map(|orbit| orbit.items.iter().map(|item| item.item.name))
            .collect();
        let name = *self.random.pick(&items)?;
        if self.rule.params.contains(&Some(name)) {
            return None;
        }
        let rule = &mut self.rule;
        if rule.kind(name) == Kind::Path {
            rule.names[name.index()].kind = Kind::Halfedge;
            return Some(());
        }
        rule.names[name.index()].kind = Kind::Path;
        for side in [&mut rule.before, &mut rule.after] {
            side.edges.retain(|edge| edge.halfedges.iter().all(|half| half.name != name));
            for star in &mut side.stars {
                star.spokes
                    .retain(|spoke| !matches!(spoke, Spoke::Halfedge(half) if half.name == name));
            }
        }
        Some(())
    }

    /// Copies a statement of `before` to `after`.
    fn copy_statement(&mut self) -> Option<()> {
        let rule = &mut self.rule;
        let picks = [self.random.below(3), self.random.next() as usize];
        let one = |count: usize| (count > 0).then(|| picks[1] % count.max(1));
        match picks[0] {
            0 => {
                let copy = rule.before.loops[one(rule.before.loops.len())?].clone();
                rule.after.loops.retain(|orbit| orbit.face.name != copy.face.name);
                rule.after.loops.push(copy);
            }
            1 => {
                let copy = rule.before.edges[one(rule.before.edges.len())?].clone();
                rule.after.edges.retain(|edge| edge.edge.name != copy.edge.name);
                rule.after.edges.push(copy);
            }
            _ => {
                let copy = rule.before.stars[one(rule.before.stars.len())?].clone();
                rule.after.stars.retain(|star| star.vertex.name != copy.vertex.name);
                rule.after.stars.push(copy);
            }
        }
        Some(())
    }

    /// Draws the twin of a halfedge on both sides.
    fn draw_a_twin(&mut self) -> Option<()> {
        let paired: Vec<_> = self
            .rule
            .before
            .edges
            .iter()
            .flat_map(|edge| edge.halfedges.map(|half| half.name))
            .collect();
        let rule = &self.rule;
        let items = rule.before.loops.iter().flat_map(|orbit| &orbit.items);
        let open: Vec<_> = items
            .map(|item| item.item.name)
            .filter(|&item| rule.kind(item) == Kind::Halfedge && !paired.contains(&item))
            .collect();
        let half = *self.random.pick(&open)?;
        let (edge, twin) = (self.fresh(Kind::Edge), self.fresh(Kind::Halfedge));
        let statement = Edge {
            edge: self.here(edge),
            halfedges: [self.here(half), self.here(twin)],
            span: self.span(),
        };
        self.rule.before.edges.push(statement.clone());
        self.rule.after.edges.push(statement);
        Some(())
    }

    /// Lists the spokes of a vertex as some completion has them.
    fn draw_a_star(&mut self) -> Option<()> {
        let drawn: Vec<_> = self
            .rule
            .before
            .loops
            .iter()
            .flat_map(|orbit| orbit.items.iter().map(|item| item.from.name))
            .collect();
        let vertex = *self.random.pick(&drawn)?;
        let star = self.star_of(vertex)?;
        self.rule.before.stars.retain(|known| known.vertex.name != vertex);
        self.rule.before.stars.push(star.clone());
        let fans = |spoke: &&Spoke| matches!(spoke, Spoke::Fan(_));
        if star.spokes.iter().any(|spoke| fans(&spoke)) {
            if self.random.once_in(2) {
                self.rule.after.stars.retain(|known| known.vertex.name != vertex);
                self.rule.after.stars.push(star);
            } else {
                // Moves the fans to the statement of another vertex, or the same one.
                let mut spokes: Vec<_> = star.spokes.iter().filter(fans).copied().collect();
                spokes.push(Spoke::Rest(self.span()));
                let to = *self.random.pick(&drawn)?;
                let span = self.span();
                match self.rule.after.stars.iter_mut().find(|star| star.vertex.name == to) {
                    Some(star) => star.spokes.extend(spokes),
                    None => {
                        let vertex = self.here(to);
                        self.rule.after.stars.push(Star { vertex, spokes, each: false, span });
                    }
                }
            }
        }
        Some(())
    }

    fn star_of(&mut self, vertex: NameId) -> Option<Star> {
        let completion = (0..20).find_map(|_| complete(self.rule, self.random))?;
        let at = VertexId(completion.elements[vertex.index()]?);
        let ring: Vec<_> = completion.mesh.spokes(at).collect();
        let halfedges: Vec<_> = self.rule.names_of(Kind::Halfedge).collect();
        let named = |id: u32| {
            let is = |&&half: &&NameId| completion.elements[half.index()] == Some(id);
            halfedges.iter().find(is).copied()
        };
        let first = ring.iter().position(|h| named(h.0).is_some())?;
        let named_fans = self.random.once_in(2);
        let mut spokes: Vec<Spoke> = Vec::new();
        let mut run = false;
        for place in 1..=ring.len() {
            let here = named(ring[(first + place - 1) % ring.len()].0);
            if let Some(half) = here {
                spokes.push(Spoke::Halfedge(self.here(half)));
                run = false;
            }
            let next_is_unnamed = named(ring[(first + place) % ring.len()].0).is_none();
            if !run && (next_is_unnamed || self.random.once_in(3)) {
                let fan = match named_fans {
                    true => Spoke::Fan(Ref::plain(self.fresh(Kind::Fan), self.span())),
                    false => Spoke::Rest(self.span()),
                };
                spokes.push(fan);
                run = true;
            }
        }
        Some(Star { vertex: self.here(vertex), spokes, each: false, span: self.span() })
    }

    /// Replaces one name by another everywhere.
    fn merge_names(&mut self) -> Option<()> {
        let [first, second] = self.two_names()?;
        if self.rule.params.contains(&Some(first)) {
            return None;
        }
        let rule = &mut self.rule;
        for side in [&mut rule.before, &mut rule.after] {
            refs(side)
                .into_iter()
                .filter(|mention| mention.name == first)
                .for_each(|mention| mention.name = second);
        }
        rule.erased.retain(|erased| erased.name != first);
        Some(())
    }

    /// Lets one vertex take over everything from another in `after`.
    fn merge_vertices(&mut self) -> Option<()> {
        let vertices: Vec<_> = self.rule.names_of(Kind::Vertex).collect();
        let from = *self.random.pick(&vertices)?;
        let to = *self.random.pick(&vertices)?;
        if from == to {
            return None;
        }
        let star = self.star_of(from)?;
        let span = self.span();
        self.rule.before.stars.retain(|known| known.vertex.name != from);
        self.rule.before.stars.push(star.clone());
        refs(&mut self.rule.after)
            .into_iter()
            .filter(|mention| mention.name == from)
            .for_each(|mention| mention.name = to);
        let mut spokes = vec![Spoke::Rest(span)];
        spokes.extend(star.spokes);
        let vertex = self.here(to);
        self.rule.after.stars.retain(|star| star.vertex.name != to);
        self.rule.after.stars.push(Star { vertex, spokes, each: false, span });
        self.rule.erased.push(Ref::plain(from, span));
        Some(())
    }
}
