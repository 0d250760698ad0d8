package org.sami.domain.mistake;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.FieldSource;

/** Mistakes that show where there is more than one boat or task. */
final class TeamMistakes {
    private static final PlanEdits CLV = new PlanEdits("clv");
    private static final PlanEdits EXPLORE = new PlanEdits("explore-area");
    private static final PlanEdits PANORAMA = new PlanEdits("panorama");
    private static final PlanEdits TOGETHER = new PlanEdits("panorama-together");

    private TeamMistakes() {}

    private static AuthorMistake of(String name, String plan, String code, String element, Edit edit) {
        return AuthorMistake.of(name, plan, code, element, edit);
    }

    static List<AuthorMistake> all() {
        List<AuthorMistake> all = new ArrayList<>();
        addGates(all);
        addEnds(all);
        addCommands(all);
        addTokens(all);
        return all;
    }

    private static void addGates(List<AuthorMistake> all) {
        all.add(of(
                "at least 1 instead of all",
                "panorama-together",
                "W-OPEN-GATE",
                "all-ready",
                TOGETHER.remove("go.all-ready", "panorama.all-ready")));
        all.add(of(
                "= 3 where the team varies",
                "panorama-together",
                "W-FIXED-NUMBER",
                "ready.all-ready",
                TOGETHER.in("ready.all-ready", "task == 3")));
        all.add(of(
                "at least 2 boats where one may be chosen",
                "bring-home",
                "W-FIXED-NUMBER",
                "go.all-home",
                new PlanEdits("bring-home").in("go.all-home", "proxy >= 2", "generic >= 1")));
        all.add(of(
                "forgotten zero at the gate",
                "panorama-together",
                "W-PLACE-FORGOTTEN",
                "go",
                TOGETHER.remove("go.all-ready")));
        all.add(of(
                "\"all finished\" forgets the failed",
                "panorama",
                "W-PLACE-FORGOTTEN",
                "failed",
                PANORAMA.remove("failed.all-finished")));
        all.add(of(
                "\"all finished\" forgets a sub-mission",
                "explore-team",
                "W-PLACE-FORGOTTEN",
                "avoid",
                new PlanEdits("explore-team").remove("avoid.all-explored")));
        all.add(of(
                "more boats wanted than the deployment has",
                RightPlans.KATARA + "bring-home",
                "W-TOO-MANY-WANTED",
                "home.all-home",
                new PlanEdits("bring-home").in("home.all-home", "proxy >= 9")));
        all.add(of(
                "inhibitors alone",
                "clv",
                "W-INHIBITORS-ONLY",
                "all-visited",
                PlanEdits.all(
                        CLV.in("execute.all-visited", "proxy = 0"),
                        CLV.remove("finished.all-visited", "left-out.all-visited"))));
    }

    private static void addEnds(List<AuthorMistake> all) {
        all.add(of(
                "ends with the first boat",
                "clv",
                "W-ENDS-WITH-FIRST",
                "visited",
                CLV.redirect("visited.finished", "visited", "end", "take all relevant")));
        all.add(of(
                "ends with the first task",
                "panorama",
                "W-ENDS-WITH-FIRST",
                "completed",
                PANORAMA.redirect("completed.finished", "completed", "end", "take all relevant")));
        all.add(of(
                "all zeros of the end forgotten",
                "panorama",
                "W-ENDS-WITH-FIRST",
                "all-finished",
                PANORAMA.remove(
                        "again.all-finished",
                        "choose.all-finished",
                        "apply.all-finished",
                        "waiting.all-finished",
                        "go.all-finished",
                        "panorama.all-finished",
                        "rest.all-finished",
                        "complete.all-finished",
                        "failed.all-finished")));
        all.add(of(
                "loop back to the start",
                "panorama",
                "W-TASKS-MADE-AGAIN",
                "retry",
                PANORAMA.redirect("retry.again", "retry", "locations", "take all task")));
        all.add(of(
                "loop back to the work that is done",
                "panorama",
                "W-GOES-ROUND",
                "go",
                PANORAMA.redirect("rested.complete", "rested", "go", "take all relevant")));
        all.add(of(
                "\"all finished\" forgets those who wait",
                "panorama",
                "W-PLACE-FORGOTTEN",
                "waiting",
                PANORAMA.remove("waiting.all-finished")));
        all.add(of(
                "loop back to where tasks are made",
                "panorama",
                "W-TASKS-MADE-AGAIN",
                "rejected",
                PANORAMA.redirect("rejected.again", "rejected", "make", "take all task")));
    }

    private static void addCommands(List<AuthorMistake> all) {
        all.add(of(
                "two commands at one place",
                "explore-area",
                "W-TWO-COMMANDS",
                "explore",
                EXPLORE.outputOf("explore", "hold", "BlockMovement", Map.of())));
        all.add(of(
                "one boat led into two commands",
                "clv",
                "W-TWO-COMMANDS",
                "accepted",
                CLV.connectOut("accepted", "go-home", "take all proxy")));
        all.add(of(
                "two takers of one answer",
                "clv",
                "W-TWO-TAKERS",
                "visited-too",
                PlanEdits.all(
                        CLV.transition("visited-too"),
                        CLV.input("visited-too", "arrived-too", "ProxyPathCompleted"),
                        CLV.connectIn("execute", "visited-too", "relevant all"),
                        CLV.connectOut("visited-too", "left-out", "take all relevant"))));
        all.add(of(
                "healthy boats led away",
                RightPlans.WATCHED,
                "W-HEALTHY-LED-AWAY",
                "weak",
                EXPLORE.waitsFor("weak-battery", "BatteryNominal")));
        all.add(of(
                "a command for nobody",
                "recharge",
                "E-NO-TOKENS",
                "go",
                new PlanEdits("recharge").out("found.go", "take 1 generic")));
        all.add(of(
                "a command as the mission ends",
                "bring-home",
                "W-COMMAND-AT-END",
                "end",
                new PlanEdits("bring-home")
                        .outputOf(
                                "end",
                                "back",
                                "ProxyGotoLatLon",
                                Map.of("location", new FieldSource.Asked(Optional.empty(), true)))));
    }

    private static void addTokens(List<AuthorMistake> all) {
        all.add(of(
                "relevant tokens without an event (before)",
                "clv",
                "E-RELEVANT-WITHOUT-EVENT",
                "all-visited",
                CLV.in("finished.all-visited", "relevant all")));
        all.add(of(
                "relevant tokens without an event (after)",
                "explore-area",
                "E-RELEVANT-WITHOUT-EVENT",
                "all-explored.end",
                EXPLORE.out("all-explored.end", "take all relevant")));
        all.add(of(
                "whom the answer names is ignored",
                "clv",
                "W-NAMED-IGNORED",
                "visited",
                PlanEdits.all(CLV.in("execute.visited", "always"), CLV.out("visited.finished", "always"))));
        all.add(AuthorMistake.deep(
                "the mission's token left behind",
                "clv",
                "W-STUCK",
                "choose",
                CLV.out("accepted.execute", "take all relevant")));
        all.add(AuthorMistake.deep(
                "one boat taken instead of all",
                "clv",
                "W-ENDS-EARLY",
                "choose",
                CLV.out("accepted.execute", "take 1 proxy", "take 1 generic")));
    }
}
