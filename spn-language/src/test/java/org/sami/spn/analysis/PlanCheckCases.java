package org.sami.spn.analysis;

import static org.sami.spn.testing.NetBuilder.project;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** For each code of a check a tiny plan that must be found, and one like it that must pass without that finding. */
final class PlanCheckCases {
    private static final FieldSource SPEED = new FieldSource.Fixed(new RealValue(1));
    private static final ValueType REAL = ValueType.Simple.REAL;
    private static final ValueType TEXT = ValueType.Simple.TEXT;

    static PlanCheckCase of(String code, NetBuilder bad, NetBuilder good) {
        return new PlanCheckCase(code, project(bad.build()), project(good.build()));
    }

    /** Start, a command to proxies, an end. */
    static NetBuilder drive() {
        return begin().output("go", "Drive", Map.of("speed", SPEED), Map.of())
                .transition("driven", "Driven")
                .waitForAll("driven")
                .in("go", "driven", "relevant all")
                .out("driven", "end", "take all relevant");
    }

    /** Start, and a transition that lets all proxies into the place go. */
    static NetBuilder begin() {
        return new NetBuilder("plan")
                .start("start")
                .end("end")
                .in("start", "first", "generic >= 1")
                .out("first", "go", "take all any");
    }

    /** Drivers may be taken to a rest on their way; the transition that takes those who arrived watches both places. */
    static NetBuilder rest(String whoArrives) {
        return begin().output("go", "Drive", Map.of("speed", SPEED), Map.of())
                .transition("driven", "Driven")
                .in("go", "driven", whoArrives)
                .in("rest", "driven", "always")
                .out("driven", "end", "take all relevant")
                .input("pause", "Interrupt", Map.of("interruptName", new TextValue("pause")), Map.of())
                .in("go", "pause", "relevant all")
                .out("pause", "rest", "take all relevant");
    }

    /** Start, a request that can fail in two ways, and a transition that waits for its success. */
    static NetBuilder fetch() {
        return endsWith(begin().output("go", "Fetch"), "fetched", "Fetched");
    }

    static NetBuilder endsWith(NetBuilder net, String transition, String input) {
        return net.transition(transition, input)
                .in("go", transition, "relevant all")
                .out(transition, "end", "take all relevant");
    }

    static NetBuilder passOn(NetBuilder net) {
        return net.in("go", "last", "any >= 1").out("last", "end", "take all any");
    }

    static NetBuilder parent(String... returned) {
        NetBuilder parent =
                new NetBuilder("plan").start("start").sub("start", "child").end("end");
        for (String value : returned) {
            parent.input("check", "CheckReturn", Map.of("value", new TextValue(value)), Map.of());
        }
        return parent.in("start", "check", "any >= 1").out("check", "end", "take all sub");
    }

    static NetBuilder child() {
        return new NetBuilder("child")
                .start("a")
                .output("b", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("yes"))), Map.of())
                .end("b")
                .in("a", "t", "any >= 1")
                .out("t", "b", "take all any");
    }

    private static PlanCheckCase withChild(String code, NetBuilder bad, NetBuilder good) {
        return new PlanCheckCase(code, project(bad.build(), child().build()), project(good.build(), child().build()));
    }

    /** A place with a shared sub-mission that robots enter by an event, and whose end place may end the instance. */
    static Project sharing(String event, boolean ends) {
        NetBuilder child =
                new NetBuilder("child").start("a").in("a", "t", "any >= 1").out("t", "b", "take all any");
        Plan parent = new NetBuilder("plan")
                .start("start")
                .shared("together", "child")
                .transition("enter", event)
                .in("start", "enter", "proxy >= 1")
                .out("enter", "together", "take all proxy")
                .build();
        return project(parent, (ends ? child.endShared("b") : child.end("b")).build());
    }

    private static MarkupSpec initiative(String trigger, boolean timeout) {
        Map<String, Value> options = new LinkedHashMap<>();
        options.put("trigger", new EnumValue("Trigger", trigger));
        if (timeout) {
            options.put("timeout", new DurationValue(1000));
        }
        return new MarkupSpec("MixedInitiativeTrigger", options);
    }

    /** All of them. */
    static List<PlanCheckCase> all() {
        List<PlanCheckCase> cases = new ArrayList<>();
        addNetCases(cases);
        addEventCases(cases);
        addTokenCases(cases);
        addVariableCases(cases);
        addSubMissionCases(cases);
        cases.addAll(GeographyChecksTest.pairs());
        cases.add(new PlanCheckCase("W-DISABLED", project(disabled(drive().build())), project(drive().build())));
        cases.addAll(ValueCheckCases.all());
        cases.addAll(TeamCheckCases.all());
        return cases;
    }

    private static Plan disabled(Plan plan) {
        return plan.withTransitions(
                plan.transitions().stream().map(t -> t.withDisabled(true)).toList());
    }

    private static void addNetCases(List<PlanCheckCase> cases) {
        cases.add(of("E-NO-START", new NetBuilder("plan").places("a").end("end"), drive()));
        cases.add(of("E-TWO-STARTS", drive().start("go"), drive()));
        cases.add(of("E-START-IS-END", drive().end("start"), drive()));
        cases.add(of("W-NO-END", new NetBuilder("plan").start("start"), drive()));
        cases.add(of("W-END-UNREACHABLE", new NetBuilder("plan").start("start").end("end"), drive()));
        cases.add(
                of("E-END-GOES-ON", drive().in("end", "more", "any >= 1").out("more", "go", "take all any"), drive()));
        cases.add(new PlanCheckCase(
                "W-ENDS-NOTHING",
                project(endsNothing(drive().build())),
                project(drive().endShared("end").build())));
        cases.add(of(
                "W-CONTRADICTION",
                begin().in("go", "last", "proxy >= 2", "any < 2").out("last", "end", "take all any"),
                begin().in("go", "last", "proxy >= 2", "any < 3").out("last", "end", "take all any")));
        cases.add(of(
                "W-CONTRADICTION",
                begin().in("go", "last", "proxy == 2", "proxy == 1").out("last", "end", "take all any"),
                begin().in("go", "last", "proxy == 2", "generic == 1").out("last", "end", "take all any")));
        cases.add(of("W-UNREACHABLE", drive().places("island"), drive()));
        cases.add(of("E-NO-REQUIREMENT", begin().in("go", "last").out("last", "end", "always"), passOn(begin())));
        cases.add(of("W-NEVER-FIRES", drive().out("ghost", "end", "always"), drive()));
        cases.add(of("W-WAITS-FOR-NOTHING", passOn(begin()).waitForAll("last"), drive().waitForAll("driven")));
        cases.add(new PlanCheckCase("E-DANGLING", project(dangling(drive().build())), project(drive().build())));
        cases.add(of(
                "W-INHIBITORS-ONLY",
                begin().in("go", "last", "any = 0").out("last", "end", "always"),
                begin().in("go", "last", "any = 0")
                        .in("start", "last", "any >= 1")
                        .out("last", "end", "always")));
        cases.add(of(
                "W-EMPTY-POOL",
                passOn(begin()).transition("news", "News").out("news", "go", "take all proxy"),
                passOn(begin()).transition("news", "News").out("news", "go", "add 1 generic")));
        cases.add(of(
                "W-LIVELOCK",
                passOn(begin()).in("go", "back", "any >= 1").out("back", "start", "take all any"),
                passOn(begin())
                        .transition("back", "News")
                        .in("go", "back", "any >= 1")
                        .out("back", "start", "take all any")));
    }

    private static Plan dangling(Plan plan) {
        List<OutEdge> edges = new ArrayList<>(plan.outEdges());
        edges.add(new OutEdge("loose", "driven", "nowhere", Mode.NOMINAL, List.of(OutRequirement.unconditional())));
        return changed(plan, plan.places(), edges);
    }

    private static Plan endsNothing(Plan plan) {
        List<Place> places = new ArrayList<>(plan.places());
        places.add(new Place("odd", "", false, false, true, Mode.NOMINAL, List.of(), List.of(), List.of()));
        return changed(plan, places, plan.outEdges());
    }

    private static Plan changed(Plan plan, List<Place> places, List<OutEdge> edges) {
        return plan.withPlaces(places).withOutEdges(edges);
    }

    private static void addEventCases(List<PlanCheckCase> cases) {
        cases.add(of("E-UNKNOWN-EVENT", passOn(begin()).output("go", "Dance"), drive()));
        cases.add(of("E-NO-CAUSE", passOn(begin()).transition("last", "Done"), drive()));
        cases.add(of(
                "E-NO-CAUSE",
                drive().in("go", "leave", "generic >= 1")
                        .out("leave", "later", "take all any")
                        .transition("late", "Driven")
                        .in("later", "late", "relevant all")
                        .out("late", "end", "take all relevant"),
                drive()));
        cases.add(of("W-UNANSWERED", passOn(begin()).output("go", "Do"), drive()));
        cases.add(of(
                "W-ANSWER-IGNORED",
                passOn(begin()).output("go", "Approve").transition("last", "Yes"),
                passOn(begin())
                        .output("go", "Approve")
                        .transition("last", "Yes")
                        .transition("no", "No")
                        .in("go", "no", "always")
                        .out("no", "end", "always")));
        cases.add(of(
                "W-FAILURE-IGNORED",
                fetch(),
                endsWith(endsWith(fetch(), "failed", "NotFetched"), "empty", "BatteryOut")));
        cases.add(of("E-FIELD-MISSING", drive().output("start", "Drive"), drive()));
        cases.add(of(
                "E-FIELD-TYPE",
                passOn(begin())
                        .output("go", "Do", Map.of("speed", new FieldSource.Fixed(new TextValue("fast"))), Map.of()),
                drive()));
        cases.add(
                of("E-UNKNOWN-FIELD", passOn(begin()).output("go", "Do", Map.of("colour", SPEED), Map.of()), drive()));
        cases.add(of(
                "W-COMMAND-AT-END",
                drive().output("end", "Drive", Map.of("speed", SPEED), Map.of()),
                drive().output("end", "Do")));
        cases.add(of(
                "W-INTERRUPT-TWICE",
                button(button(drive(), "one", "go"), "two", "go"),
                button(button(drive(), "one", "go"), "two", "start")));
        cases.add(of(
                "E-NO-TIMEOUT",
                drive().output("go", "Approve", initiative("TIMER", false)),
                drive().output("go", "Approve", initiative("TIMER", true))));
        cases.add(of(
                "E-DRAWN-BY-AUTONOMY",
                drive().output("go", "Provide", initiative("IMMEDIATELY", false)),
                drive().output("go", "Approve", initiative("IMMEDIATELY", false))));
        cases.add(of(
                "W-NO-AUTOMATIC-ANSWER",
                drive().output("go", "Do", initiative("IMMEDIATELY", false)),
                drive().output("go", "Approve", initiative("IMMEDIATELY", false))));
    }

    static NetBuilder button(NetBuilder net, String transition, String place) {
        return net.input(transition, "Interrupt", Map.of("interruptName", new TextValue("stop")), Map.of())
                .in(place, transition, "always")
                .out(transition, "end", "take all any");
    }

    private static void addTokenCases(List<PlanCheckCase> cases) {
        NetBuilder onlyGeneric = new NetBuilder("plan")
                .start("start")
                .in("start", "first", "generic >= 1")
                .out("first", "go", "take 1 generic")
                .output("go", "Drive", Map.of("speed", SPEED), Map.of());
        NetBuilder byNobody = new NetBuilder("plan")
                .start("start")
                .in("start", "first", "generic >= 1")
                .out("first", "go", "always")
                .output("go", "Drive", Map.of("speed", SPEED), Map.of());
        cases.add(of("E-NO-TOKENS", onlyGeneric, drive()));
        cases.add(of("W-NO-TOKENS", byNobody, drive()));
        cases.add(of(
                "W-NAMED-IGNORED",
                begin().output("go", "Drive", Map.of("speed", SPEED), Map.of())
                        .transition("driven", "Driven")
                        .in("go", "driven", "always")
                        .out("driven", "end", "always"),
                drive()));
        cases.add(of("E-RELEVANT-WITHOUT-EVENT", passOn(begin()).in("start", "last", "relevant all"), drive()));
        cases.add(of(
                "W-RELEVANT-NOBODY",
                passOn(begin()).transition("last", "News").in("start", "last", "relevant all"),
                drive()));
        MarkupSpec branch = new MarkupSpec("PhaseBranch", Map.of("actionName", new TextValue("Go")));
        MarkupSpec item = new MarkupSpec("PhaseItem", Map.of("phaseName", new TextValue("Way")));
        cases.add(of(
                "W-PHASE-BRANCH",
                drive().output("end", "Fetch", branch),
                drive().output("go", "Fetch", item).output("end", "Fetch", branch)));
        cases.add(of("W-ANSWER-MISSED", rest("relevant all"), rest("relevant >= 1")));
        NetBuilder tasks = passOn(begin()).task("T", "Measure", Map.of());
        cases.add(of(
                "E-UNKNOWN-TASK",
                passOn(begin()).in("start", "last", "task:T >= 1"),
                tasks.in("start", "last", "task:T >= 1", "task:Look >= 1")));
        cases.add(of(
                "E-TASK-FIELD",
                passOn(begin()).output("go", "Do", Map.of("speed", new FieldSource.FromTask()), Map.of()),
                passOn(begin()).output("go", "Do", Map.of("point", new FieldSource.FromTask()), Map.of())));
    }

    static NetBuilder reading(String variable) {
        return passOn(begin()).output("go", "Do", Map.of("speed", new FieldSource.FromVariable(variable)), Map.of());
    }

    private static void addVariableCases(List<PlanCheckCase> cases) {
        cases.add(of("E-VARIABLE-UNKNOWN", reading("@v"), reading("@v").variable("@v", REAL)));
        cases.add(of(
                "E-VARIABLE-TYPE",
                reading("@v").variable("@v", TEXT),
                reading("@v").variable("@v", ValueType.Simple.INTEGER)));
        cases.add(of(
                "E-VARIABLE-TYPE",
                reading("@v").variable("@v", REAL, new TextValue("fast")),
                reading("@v").variable("@v", REAL, new IntegerValue(1))));
        cases.add(of(
                "E-VARIABLE-TYPE",
                reading("@v").input("last", "Failed", Map.of(), Map.of("reason", "@v")),
                reading("@v").input("last", "Done", Map.of(), Map.of("value", "@v"))));
        cases.add(of(
                "W-VARIABLE-UNREAD",
                passOn(begin()).variable("@v", REAL),
                reading("@v").variable("@v", REAL)));
        cases.add(of(
                "W-VARIABLE-UNREAD",
                passOn(begin()).input("last", "News", Map.of(), Map.of("value", "@v")),
                reading("@v").input("last", "News", Map.of(), Map.of("value", "@v"))));
        cases.add(of(
                "W-VARIABLE-NEVER-WRITTEN",
                reading("@v").variable("@v", REAL),
                reading("@v").variable("@v", REAL, new RealValue(1))));
        Plan reader = child().output("a", "Do", Map.of("speed", new FieldSource.FromVariable("@c")), Map.of())
                .variable("@c", REAL)
                .build();
        NetBuilder unmapped = parent().sub("start", "child", false, Map.of(), Map.of());
        NetBuilder mapped = parent().sub("start", "child", false, Map.of(), Map.of("@c", "@p"))
                .variable("@p", REAL, new RealValue(1));
        cases.add(new PlanCheckCase(
                "W-VARIABLE-NEVER-WRITTEN", project(unmapped.build(), reader), project(mapped.build(), reader)));
        FieldSource name = new FieldSource.Fixed(new VariableReference("@v"));
        cases.add(of(
                "E-VARIABLE-UNKNOWN",
                passOn(begin()).output("go", "Redefine", Map.of("variable", name), Map.of()),
                reading("@v").variable("@v", REAL).output("go", "Redefine", Map.of("variable", name), Map.of())));
        cases.add(withChild(
                "E-VARIABLE-UNKNOWN",
                parent().sub("start", "child", false, Map.of(), Map.of("@c", "@p")),
                parent().sub("start", "child", false, Map.of(), Map.of("@c", "@p"))
                        .variable("@p", REAL)));
    }

    private static void addSubMissionCases(List<PlanCheckCase> cases) {
        cases.add(new PlanCheckCase(
                "E-UNKNOWN-PLAN", project(parent().build()), project(parent().build(), child().build())));
        cases.add(withChild("E-RECURSION", parent().sub("start", "plan"), parent()));
        cases.add(new PlanCheckCase(
                "W-SUB-MISSION-ENDLESS",
                project(parent().build(), new NetBuilder("child").start("a").build()),
                project(parent().build(), child().build())));
        cases.add(new PlanCheckCase("W-SHARED-OVER", sharing("News", true), sharing("News", false)));
        cases.add(new PlanCheckCase("W-SHARED-OVER", sharing("News", true), sharing("TimerExpired", true)));
        cases.add(withChild("W-SHARED-AT-START", parent().shared("start", "child"), parent()));
        cases.add(of(
                "E-NO-SUB-MISSION", begin().in("go", "last", "any >= 1").out("last", "end", "take all sub"), drive()));
        cases.add(of(
                "E-NO-SUB-MISSION",
                passOn(begin()).input("last", "CheckReturn", Map.of("value", new TextValue("yes")), Map.of()),
                drive()));
        cases.add(withChild("W-NEVER-RETURNED", parent("no"), parent("yes")));
        cases.add(withChild(
                "E-UNKNOWN-TASK", parent().sub("start", "child", false, Map.of("T", "U"), Map.of()), parent()));
    }

    private PlanCheckCases() {}
}
