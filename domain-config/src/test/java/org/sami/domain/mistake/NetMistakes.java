package org.sami.domain.mistake;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.value.TextValue;

/** Mistakes in how a net is drawn: its places, edges and events. */
final class NetMistakes {
    private static final PlanEdits CLV = new PlanEdits("clv");
    private static final PlanEdits EXPLORE = new PlanEdits("explore-area");
    private static final PlanEdits HOME = new PlanEdits("bring-home");
    private static final PlanEdits DANGER = new PlanEdits("clv-dangerous-area");

    private NetMistakes() {}

    private static AuthorMistake of(String name, String plan, String code, String element, Edit edit) {
        return AuthorMistake.of(name, plan, code, element, edit);
    }

    static List<AuthorMistake> all() {
        List<AuthorMistake> all = new ArrayList<>();
        addPlaces(all);
        addEvents(all);
        addSubMissions(all);
        return all;
    }

    private static void addPlaces(List<AuthorMistake> all) {
        all.add(of("missing start", "clv", "E-NO-START", "clv", CLV.remove("select")));
        all.add(of("missing end", "clv", "W-NO-END", "clv", CLV.end("end", false)));
        all.add(of("no way to the end", "clv", "W-END-UNREACHABLE", "end", CLV.remove("all-visited.end")));
        all.add(of("more after the end", "clv", "E-END-GOES-ON", "go-home", CLV.end("go-home", true)));
        all.add(of(
                "unreachable place", "explore-area", "W-UNREACHABLE", "wait", EXPLORE.remove("somebody-passes.wait")));
        all.add(of("missing requirement", "clv", "E-NO-REQUIREMENT", "execute.visited", CLV.in("execute.visited")));
        all.add(of(
                "requirements that contradict",
                "clv",
                "W-CONTRADICTION",
                "execute.all-visited",
                CLV.in("execute.all-visited", "proxy = 0", "proxy >= 1")));
        all.add(of("livelock", "explore-area", "W-LIVELOCK", "not-clear", EXPLORE.remove("not-yet")));
    }

    private static void addEvents(List<AuthorMistake> all) {
        all.add(of(
                "the wrong answer awaited", "clv", "E-NO-CAUSE", "arrived", CLV.waitsFor("arrived", "PanoramaTaken")));
        all.add(of("no answer awaited", "bring-home", "W-UNANSWERED", "gather", HOME.remove("berths-found")));
        all.add(of("no way on after \"no\"", "clv", "W-ANSWER-IGNORED", "choose", CLV.remove("rejected")));
        all.add(of("no way on after a failure", "clv", "W-FAILURE-IGNORED", "execute", CLV.remove("path-failed")));
        all.add(of(
                "two buttons of one name",
                "explore-area",
                "W-INTERRUPT-TWICE",
                "again-pressed",
                PlanEdits.all(
                        EXPLORE.transition("again-pressed"),
                        EXPLORE.input("again-pressed", "again-button", "OperatorInterruptReceived"),
                        EXPLORE.button("again-button", "Let somebody pass"),
                        EXPLORE.connectIn("explore", "again-pressed", "proxy >= 1"),
                        EXPLORE.connectOut("again-pressed", "failed", "take all proxy"))));
        all.add(new AuthorMistake(
                "yes and no exchanged",
                "explore-area",
                PlanEdits.all(EXPLORE.waitsFor("clear", "NoOption"), EXPLORE.waitsFor("not-yet", "YesOption")),
                "",
                "",
                false));
    }

    private static void addSubMissions(List<AuthorMistake> all) {
        SubMissionSpec recharge = RightPlans.of("clv-interrupts")
                .plan("clv-interrupts")
                .orElseThrow()
                .place("recharge")
                .orElseThrow()
                .subMissions()
                .get(0);
        all.add(of(
                "wrong sub-mission: itself",
                "clv-interrupts",
                "E-RECURSION",
                "run-recharge",
                new EventEdit.ChangeSubMission(
                        "clv-interrupts", recharge.withPlan("clv-interrupts").withVariables(Map.of()))));
        all.add(of(
                "the sub-mission returns another word",
                "clv-dangerous-area",
                "W-NEVER-RETURNED",
                "through",
                new FieldEdit.SetInputField("clv-dangerous-area", "returned-out", "value", new TextValue("outside"))));
        all.add(of(
                "tokens of a sub-mission that is gone",
                "explore-team",
                "E-NO-SUB-MISSION",
                "has-passed.explore",
                new PlanEdits("explore-team").remove("run-avoid")));
        all.add(of(
                "boats enter a shared sub-mission by nothing",
                "clv-dangerous-area",
                "W-UNREACHABLE",
                "line",
                PlanEdits.all(DANGER.remove("start-traverse"))));
    }
}
