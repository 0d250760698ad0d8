package org.sami.spn.analysis;

import static org.sami.spn.analysis.PlanCheckCases.begin;
import static org.sami.spn.analysis.PlanCheckCases.passOn;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.FieldSource;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;

/** Pairs of plans for the checks of what goes wrong where there is more than one robot or task. */
final class TeamCheckCases {
    private static final Map<String, FieldSource> SPEED = Map.of("speed", new FieldSource.Fixed(new RealValue(1)));

    private TeamCheckCases() {}

    /** Robots that drive gather in the place here. */
    static NetBuilder gather() {
        return begin().output("go", "Drive", SPEED, Map.of())
                .transition("driven", "Driven")
                .in("go", "driven", "relevant all")
                .out("driven", "here", "take all relevant");
    }

    private static NetBuilder ending(String... requirements) {
        return gather().in("here", "last", requirements).out("last", "end", "take all proxy");
    }

    /** Robots that drive may be taken to a rest and come back. */
    private static NetBuilder resting() {
        return ending("proxy >= 1")
                .in("go", "last", "proxy = 0")
                .transition("pause", "News")
                .in("go", "pause", "proxy >= 1")
                .out("pause", "rest", "take all proxy")
                .transition("resume", "Other")
                .in("rest", "resume", "proxy >= 1")
                .out("resume", "go", "take all proxy");
    }

    /** Copies of the robots lie in a place that is to be empty at the end, until a transition takes them out of it. */
    private static NetBuilder counted(String out) {
        return resting()
                .out("first", "team", "add all proxy")
                .in("team", "last", "proxy = 0")
                .in("team", out, "always");
    }

    private static NetBuilder gate(NetBuilder net) {
        return net.in("here", "together", "proxy >= 1")
                .out("together", "home", "take all proxy")
                .in("home", "last", "proxy >= 1", "generic >= 1")
                .out("last", "end", "take all any");
    }

    /** Tasks are made, done in the place work, and those of which there is news led to a place. */
    private static NetBuilder again(String place) {
        return new NetBuilder("plan")
                .start("start")
                .end("end")
                .in("start", "first", "generic >= 1")
                .out("first", "make", "take all any")
                .output(
                        "make",
                        "GenerateTasks",
                        Map.of(
                                "locations",
                                new FieldSource.Fixed(new ListValue(List.of())),
                                "taskClass",
                                new FieldSource.Fixed(new TextValue("Measure"))),
                        Map.of())
                .transition("made", "TasksGenerated")
                .in("make", "made", "generic >= 1")
                .out("made", "work", "take all any", "add all relevant")
                .transition("back", "News")
                .in("work", "back", "task:Measure >= 1")
                .out("back", place, "take all task:Measure")
                .in("later", "last", "any >= 1")
                .out("last", "end", "take all any")
                .places("later");
    }

    private static NetBuilder takers(String first, String second) {
        return begin().output("go", "Do")
                .transition("one", "Done")
                .in("go", "one", first)
                .out("one", "end", "take all any")
                .transition("two", "Done")
                .in("go", "two", second)
                .out("two", "end", "take all any");
    }

    static List<PlanCheckCase> all() {
        List<PlanCheckCase> cases = new ArrayList<>();
        NetBuilder single = begin().output("go", "Drive", SPEED, Map.of())
                .transition("driven", "Driven")
                .in("go", "driven", "relevant all")
                .out("driven", "end", "take all relevant");
        cases.add(PlanCheckCases.of("W-ENDS-WITH-FIRST", single, PlanCheckCases.drive()));
        cases.add(PlanCheckCases.of(
                "W-ENDS-WITH-FIRST", ending("proxy >= 1"), ending("proxy >= 1").in("go", "last", "proxy = 0")));
        cases.add(PlanCheckCases.of("W-PLACE-FORGOTTEN", resting(), resting().in("rest", "last", "proxy = 0")));
        cases.add(PlanCheckCases.of("W-PLACE-FORGOTTEN", counted("pause"), counted("driven")));
        cases.add(PlanCheckCases.of(
                "W-PLACE-FORGOTTEN",
                gate(gather().in("home", "together", "proxy = 0")),
                gate(gather().in("home", "together", "proxy = 0").in("go", "together", "proxy = 0"))));
        cases.add(PlanCheckCases.of("W-OPEN-GATE", gate(gather()), gate(gather().in("go", "together", "proxy = 0"))));
        cases.add(PlanCheckCases.of("W-FIXED-NUMBER", ending("proxy == 3"), ending("proxy >= 1")));
        cases.add(PlanCheckCases.of(
                "W-FIXED-NUMBER",
                ending("proxy >= 2"),
                ending("proxy >= 2").in("here", "few", "proxy < 2").out("few", "end", "always")));
        cases.add(PlanCheckCases.of(
                "W-TOO-MANY-WANTED",
                passOn(begin().task("T", "Measure", Map.of())).in("start", "last", "task >= 2"),
                passOn(begin().task("T", "Measure", Map.of())).in("start", "last", "task >= 1")));
        cases.add(PlanCheckCases.of(
                "W-TOO-MANY-WANTED",
                begin().in("go", "last", "generic >= 2").out("last", "end", "take all any"),
                begin().out("first", "go", "add 1 generic")
                        .in("go", "last", "generic >= 2")
                        .out("last", "end", "take all any")));
        cases.add(PlanCheckCases.of("W-TWO-COMMANDS", gather().output("go", "Sail"), gather().output("here", "Sail")));
        cases.add(PlanCheckCases.of(
                "W-TWO-COMMANDS",
                gather().output("sea", "Sail").out("first", "sea", "take all proxy"),
                gather().output("sea", "Sail").out("first", "sea", "take 1 generic")));
        cases.add(PlanCheckCases.of("W-TWO-TAKERS", takers("any >= 1", "any >= 1"), takers("any >= 2", "any >= 1")));
        cases.add(PlanCheckCases.of("W-HEALTHY-LED-AWAY", well("go"), well("watch")));
        cases.add(PlanCheckCases.of("W-TASKS-MADE-AGAIN", again("start"), again("later")));
        cases.add(PlanCheckCases.of("W-TASKS-MADE-AGAIN", again("make"), again("later")));
        cases.add(PlanCheckCases.of("W-GOES-ROUND", round("go"), round("end")));
        return cases;
    }

    /** Tasks are to drive and to fetch, and are led to a place when that is done; those that cannot fetch are over. */
    private static NetBuilder round(String place) {
        return begin().task("T", "Measure", Map.of())
                .output("go", "Drive", SPEED, Map.of())
                .output("go", "Fetch")
                .transition("driven", "Driven")
                .in("go", "driven", "relevant all")
                .out("driven", place, "take all relevant")
                .transition("nothing", "NotFetched")
                .in("go", "nothing", "relevant all")
                .out("nothing", "end", "take all relevant");
    }

    /** Robots are watched where they drive or in another place, and led to the end when they are well. */
    private static NetBuilder well(String place) {
        return gather().output(place, "Watch")
                .transition("well", "Well")
                .in(place, "well", "relevant all")
                .out("well", "end", "take all relevant")
                .out("first", "watch", "add all proxy");
    }
}
