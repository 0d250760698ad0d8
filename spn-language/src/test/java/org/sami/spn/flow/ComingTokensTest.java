package org.sami.spn.flow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.flow.TokenType.GENERIC;
import static org.sami.spn.flow.TokenType.PROXY;
import static org.sami.spn.flow.TokenType.TASK;

import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.Plan;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.GeoPoint;

/** Which kinds of tokens come where, by the sentences of docs/semantics.md: as little as the rules let come, and nothing less. */
class ComingTokensTest {
    private static Set<TokenType> in(String place, Plan plan, Plan... others) {
        Plan[] all = new Plan[others.length + 1];
        all[0] = plan;
        System.arraycopy(others, 0, all, 1, others.length);
        return new ComingTokens(NetBuilder.project(all), plan, TestVocabulary.TEST).in(place);
    }

    private static NetBuilder withTask(String id) {
        return new NetBuilder(id).start("s").task("T", "Measure", Map.of("point", GeoPoint.of(1, 2)));
    }

    private static NetBuilder child() {
        return new NetBuilder("child").start("c").end("e");
    }

    /** A way on from a place to another, with one requirement each. */
    private static NetBuilder way(NetBuilder net, String from, String wanted, String moved, String to) {
        return net.transition(from + "-" + to).in(from, from + "-" + to, wanted).out(from + "-" + to, to, moved);
    }

    // ---- Start

    @Test
    void missionBeginsWithItsTokenItsRobotsAndTheTasksOfItsPlan() {
        assertThat(in("s", new NetBuilder("p").start("s").build())).containsExactlyInAnyOrder(GENERIC, PROXY);
        assertThat(in("s", withTask("p").build())).containsExactlyInAnyOrder(GENERIC, PROXY, TASK);
    }

    @Test
    void parentThatHasNoTasksBringsNone() {
        Plan parent = way(new NetBuilder("parent").start("s").sub("w", "child"), "s", "any >= 1", "take all any", "w")
                .build();

        assertThat(in("c", child().build(), parent)).containsExactlyInAnyOrder(GENERIC, PROXY);
    }

    @Test
    void parentWhoseTasksDoNotComeToTheSubMissionBringsNone() {
        Plan parent = way(
                        way(withTask("parent").sub("w", "child"), "s", "proxy >= 1", "take all proxy", "w"),
                        "s",
                        "task >= 1",
                        "take all task",
                        "elsewhere")
                .build();

        assertThat(in("c", child().build(), parent)).doesNotContain(TASK);
    }

    @Test
    void tasksComeThroughAnyOfSeveralParentsOfOneParent() {
        Plan one = way(new NetBuilder("one").start("s").sub("w", "child"), "s", "proxy >= 1", "take all proxy", "w")
                .build();
        Plan other = way(new NetBuilder("other").start("s").sub("w", "child"), "s", "any >= 1", "take all any", "w")
                .build();
        Plan top = way(
                        way(
                                withTask("top").sub("a", "one").sub("b", "other"),
                                "s",
                                "proxy >= 1",
                                "take all proxy",
                                "a"),
                        "s",
                        "task >= 1",
                        "take all task",
                        "b")
                .build();

        assertThat(in("c", child().build(), one, other, top)).contains(TASK);
        assertThat(in("c", child().build(), other, one, top)).contains(TASK);
    }

    @Test
    void plansThatRunEachOtherComeToAnEnd() {
        Plan one = way(withTask("one").sub("w", "other"), "s", "any >= 1", "take all any", "w")
                .build();
        Plan other = way(new NetBuilder("other").start("c").sub("v", "one"), "c", "any >= 1", "take all any", "v")
                .build();

        assertThat(in("v", other, one)).contains(TASK);
        assertThat(in("s", one, other)).contains(TASK);
    }

    // ---- In edges

    @Test
    void kindOfWhichNoneMayBeThereIsNotInThePool() {
        Plan plan = way(withTask("p"), "s", "task = 0", "take all any", "on").build();

        assertThat(in("on", plan)).containsExactlyInAnyOrder(GENERIC, PROXY);
    }

    @Test
    void absenceOfOneTaskOrOfTheNamedOnesLeavesOthersThere() {
        Plan relevant = new NetBuilder("p")
                .start("s")
                .transition("t", "Interrupt")
                .in("s", "t", "relevant = 0")
                .out("t", "on", "take all proxy")
                .build();
        Plan named =
                way(withTask("p"), "s", "task:T = 0", "take all task", "on").build();

        assertThat(in("on", relevant)).containsExactly(PROXY);
        assertThat(in("on", named)).containsExactly(TASK);
    }

    // ---- Out edges

    @Test
    void allGenericAreAsManyAsThereAre() {
        NetBuilder robots = way(new NetBuilder("p").start("s"), "s", "proxy >= 1", "take all proxy", "a");

        assertThat(in(
                        "b",
                        way(robots, "a", "proxy >= 1", "add all generic", "b").build()))
                .isEmpty();
        assertThat(in("b", way(robots, "a", "proxy >= 1", "add 1 generic", "b").build()))
                .containsExactly(GENERIC);
    }

    @Test
    void genericTokenComesBackFromASubMissionAsWell() {
        Plan parent = way(
                        way(new NetBuilder("p").start("s").sub("w", "child"), "s", "any >= 1", "take all any", "w"),
                        "w",
                        "always",
                        "take all sub",
                        "back")
                .build();

        assertThat(in("back", parent, child().build())).containsExactlyInAnyOrder(GENERIC, PROXY);
    }

    @Test
    void subMissionBringsBackWhomItMadeItselfButNoTasksOfItsOwn() {
        Plan parent = way(
                        way(
                                new NetBuilder("p").start("s").sub("w", "child"),
                                "s",
                                "generic >= 1",
                                "take 1 generic",
                                "w"),
                        "w",
                        "always",
                        "take all sub",
                        "back")
                .build();
        Plan naming = child().transition("all", "GotAll")
                .in("c", "all", "generic >= 1")
                .out("all", "e", "add all relevant")
                .build();
        Plan making = child().transition("made", "TasksGenerated")
                .in("c", "made", "generic >= 1")
                .out("made", "e", "add all relevant")
                .build();

        assertThat(in("back", parent, naming)).containsExactlyInAnyOrder(GENERIC, PROXY);
        assertThat(in("back", parent, making)).containsExactly(GENERIC);
    }

    // ---- Whom events name

    private static Set<TokenType> added(String event) {
        return in(
                "on",
                new NetBuilder("p")
                        .start("s")
                        .transition("t", event)
                        .in("s", "t", "generic >= 1")
                        .out("t", "on", "add all relevant")
                        .build());
    }

    @ParameterizedTest
    @ValueSource(strings = {"Interrupt", "GeneralInterruptReceived", "ProxyInterruptReceived", "GotAll", "Pose"})
    void robotsThatAnEventNamesAreAdded(String event) {
        assertThat(added(event)).containsExactly(PROXY);
    }

    @ParameterizedTest
    @ValueSource(strings = {"ProxyTimerExpired", "SubMissionAborted"})
    void robotsAndTasksThatAnEventNamesAreAdded(String event) {
        assertThat(added(event)).containsExactlyInAnyOrder(PROXY, TASK);
    }

    @Test
    void tasksThatAreMadeAreAdded() {
        assertThat(added("TasksGenerated")).containsExactly(TASK);
    }

    @ParameterizedTest
    @ValueSource(strings = {"TimerExpired", "AbortReceived", "CompleteReceived", "CheckReturn", "Yes"})
    void nobodyIsAddedByAnEventThatNamesNobody(String event) {
        assertThat(added(event)).isEmpty();
    }

    @Test
    void relevantTokensAreTakenOnlyWhereAnEventNamesThem() {
        NetBuilder net = withTask("p");
        for (String event : new String[] {"Pose", "TasksGenerated", "Yes"}) {
            net.transition(event, event).in("s", event, "any >= 1").out(event, "by-" + event, "take all relevant");
        }

        assertThat(in("by-Pose", net.build()))
                .as("a robot's name speaks of its tasks as well (R-REL-3)")
                .containsExactlyInAnyOrder(PROXY, TASK);
        assertThat(in("by-TasksGenerated", net.build())).containsExactly(TASK);
        assertThat(in("by-Yes", net.build())).isEmpty();
    }
}
