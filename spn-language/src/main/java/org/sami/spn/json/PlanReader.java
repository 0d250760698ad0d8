package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Note;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.Transition;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.model.WaitFor;

/** Reads one plan of a project. */
final class PlanReader {
    private final PlanParts parts;
    private final JsonObjectReader m;
    private final List<VariableSpec> globals;
    private final Names planIds;
    private final Names ids;
    private final Names places;
    private final Names transitions;
    private final EventSpecReader events;
    private final RequirementReader requirements;

    PlanReader(PlanParts parts, JsonObjectReader plan, List<VariableSpec> globals, Names planIds) {
        this.parts = parts;
        this.m = plan;
        this.globals = globals;
        this.planIds = planIds;
        this.ids = new Names(parts.problems());
        // their duplicates are reported once, by ids
        this.places = new Names(new Problems());
        this.transitions = new Names(new Problems());
        this.events = new EventSpecReader(parts, ids);
        this.requirements = new RequirementReader();
    }

    Plan read() {
        String id = m.text("id");
        String name = m.text("name", "");
        String description = m.text("description", "");
        var variables = parts.variables(m, "variables");
        List<String> reads = m.texts("reads");
        reads.forEach(r -> parts.checkVariable(r, m.at("reads")));
        var tasks = parts.tasks(m);
        List<Place> readPlaces = m.objects("places").stream().map(this::place).toList();
        List<Transition> readTransitions =
                m.objects("transitions").stream().map(this::transition).toList();
        checkOrders(readPlaces);
        List<InEdge> inEdges = m.objects("inEdges").stream().map(this::inEdge).toList();
        List<OutEdge> outEdges =
                m.objects("outEdges").stream().map(this::outEdge).toList();
        checkParallel(inEdges, outEdges);
        Map<String, LayoutPoint> layout = layout();
        NoteReader noteReader = new NoteReader(parts.problems());
        List<Note> notes = m.array("notes").stream()
                .map(noteReader::read)
                .flatMap(Optional::stream)
                .toList();
        List<NetFrame> frames = m.objects("frames").stream()
                .map(FrameReader::read)
                .flatMap(Optional::stream)
                .toList();
        TestCaseReader testCases = new TestCaseReader(parts, readPlaces, globals, variables, events.refused());
        List<TestCase> cases =
                m.objects("testCases").stream().map(testCases::read).toList();
        Names queryNames = new Names(parts.problems());
        List<PlanQuery> queries =
                m.objects("queries").stream().map(q -> query(q, queryNames)).toList();
        m.done();
        return new Plan(
                id,
                name,
                description,
                readPlaces,
                readTransitions,
                inEdges,
                outEdges,
                variables,
                reads,
                tasks,
                layout,
                notes,
                frames,
                cases,
                queries);
    }

    /** What its text means is found out by those who search; here it is a text. */
    private static PlanQuery query(JsonObjectReader q, Names names) {
        String name = q.text("name");
        names.take(name, q.at("name"));
        PlanQuery query =
                new PlanQuery(name, q.text("text"), q.word("expect", PlanQuery.Expected.class, PlanQuery.Expected.YES));
        q.done();
        return query;
    }

    private Place place(JsonObjectReader p) {
        String id = vertex(p, places);
        Place place = new Place(
                id,
                p.text("name", ""),
                p.flag("start"),
                p.flag("end"),
                p.flag("endsSharedInstance"),
                p.word("mode", Mode.class, Mode.NOMINAL),
                p.objects("outputs").stream()
                        .map(events::output)
                        .flatMap(Optional::stream)
                        .toList(),
                p.objects("subMissions").stream().map(this::subMission).toList(),
                p.texts("transitionOrder"),
                p.flag("disabled"));
        p.done();
        return place;
    }

    private Transition transition(JsonObjectReader t) {
        String id = vertex(t, transitions);
        Transition transition = new Transition(
                id,
                t.text("name", ""),
                t.word("mode", Mode.class, Mode.NOMINAL),
                t.word("waitFor", WaitFor.class, WaitFor.EACH),
                t.objects("inputs").stream()
                        .map(events::input)
                        .flatMap(Optional::stream)
                        .toList(),
                t.flag("disabled"));
        t.done();
        return transition;
    }

    private String vertex(JsonObjectReader v, Names kind) {
        String id = v.text("id");
        ids.take(id, v.at("id"));
        kind.take(id, v.pointer());
        return id;
    }

    private SubMissionSpec subMission(JsonObjectReader s) {
        String id = s.text("id");
        ids.take(id, s.at("id"));
        String plan = s.text("plan");
        if (!plan.isEmpty() && !planIds.has(plan)) {
            s.problem(
                    Codes.UNKNOWN_PLAN,
                    "plan",
                    "There is no plan \"" + plan + "\" in this project" + planIds.meant(plan),
                    id);
        }
        Map<String, String> variables = s.textMap("variables");
        variables.forEach((child, parent) -> {
            String where = Problems.at(s.at("variables"), child);
            parts.checkVariable(child, where);
            parts.checkVariable(parent, where);
        });
        SubMissionSpec spec = new SubMissionSpec(id, plan, s.flag("shared"), s.textMap("tasks"), variables);
        s.done();
        return spec;
    }

    private void checkOrders(List<Place> readPlaces) {
        for (int i = 0; i < readPlaces.size(); i++) {
            for (String t : readPlaces.get(i).transitionOrder()) {
                if (!transitions.has(t)) {
                    m.problem(
                            Codes.DANGLING,
                            "places",
                            "The place " + readPlaces.get(i).id() + " orders a transition \"" + t
                                    + "\" that is not there" + transitions.meant(t),
                            readPlaces.get(i).id());
                }
            }
        }
    }

    private InEdge inEdge(JsonObjectReader e) {
        String id = e.text("id");
        ids.take(id, e.at("id"));
        String place = end(e, "place", places);
        String transition = end(e, "transition", transitions);
        InEdge edge = new InEdge(
                id,
                place,
                transition,
                e.word("mode", Mode.class, Mode.NOMINAL),
                e.objects("requirements").stream()
                        .map(requirements::in)
                        .flatMap(Optional::stream)
                        .toList(),
                e.flag("locked"));
        e.done();
        return edge;
    }

    private OutEdge outEdge(JsonObjectReader e) {
        String id = e.text("id");
        ids.take(id, e.at("id"));
        String transition = end(e, "transition", transitions);
        String place = end(e, "place", places);
        OutEdge edge = new OutEdge(
                id,
                transition,
                place,
                e.word("mode", Mode.class, Mode.NOMINAL),
                e.objects("requirements").stream()
                        .map(requirements::out)
                        .flatMap(Optional::stream)
                        .toList(),
                e.flag("locked"));
        e.done();
        return edge;
    }

    private static String end(JsonObjectReader e, String member, Names vertices) {
        String id = e.text(member);
        if (!id.isEmpty() && !vertices.has(id)) {
            e.problem(
                    Codes.DANGLING,
                    member,
                    "The edge " + e.text("id", "") + " hangs in the air: there is no " + member + " \"" + id + "\""
                            + vertices.meant(id),
                    e.text("id", ""));
        }
        return id;
    }

    /** Two edges between the same two vertices in one direction would be one edge drawn twice. */
    private void checkParallel(List<InEdge> inEdges, List<OutEdge> outEdges) {
        Names pairs = new Names(new Problems());
        for (int i = 0; i < inEdges.size(); i++) {
            InEdge e = inEdges.get(i);
            checkPair(pairs, e.place() + " > " + e.transition(), Problems.at(m.at("inEdges"), i), e.id());
        }
        for (int i = 0; i < outEdges.size(); i++) {
            OutEdge e = outEdges.get(i);
            checkPair(pairs, e.transition() + " > " + e.place(), Problems.at(m.at("outEdges"), i), e.id());
        }
    }

    private void checkPair(Names pairs, String pair, String pointer, String id) {
        if (pairs.has(pair)) {
            parts.problems()
                    .add(Codes.DUPLICATE, pointer, "The edge " + id + " joins what is joined already: " + pair, id);
        }
        pairs.take(pair, pointer);
    }

    private Map<String, LayoutPoint> layout() {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        m.map("layout").forEach((id, element) -> {
            JsonNode xy = element.node();
            if (!places.has(id) && !transitions.has(id)) {
                parts.problems()
                        .add(
                                Codes.DANGLING,
                                element.pointer(),
                                "There is no vertex \"" + id + "\" to lay out" + ids.meant(id),
                                id);
            } else if (!xy.isArray()
                    || xy.size() != 2
                    || !xy.get(0).isNumber()
                    || !xy.get(1).isNumber()) {
                parts.problems().add(Codes.WRONG_TYPE, element.pointer(), "A vertex is laid out at [x, y]", id);
            } else {
                layout.put(
                        id, new LayoutPoint(xy.get(0).doubleValue(), xy.get(1).doubleValue()));
            }
        });
        return layout;
    }
}
