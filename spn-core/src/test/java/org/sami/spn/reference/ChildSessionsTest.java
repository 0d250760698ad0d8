package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.TextValue;

/** Sessions through sub-missions, each firing of which the net does after the engine. */
class ChildSessionsTest {
    private static final Input START = new Input.StartMission("main", "m", Map.of());

    private static Input news(String type, String... robots) {
        return new Input.Received(Occurrence.news(type, List.of(robots), Map.of()));
    }

    /** Robots enter {@code q1}, where the child runs, one by one, and those that came back go on to {@code q2}. */
    private static NetBuilder parent() {
        return new NetBuilder("main")
                .start("q0")
                .places("q1", "q2")
                .transition("enter", "Other")
                .in("q0", "enter", "relevant all")
                .out("enter", "q1", "take all relevant")
                .transition("leave")
                .in("q1", "leave", "always")
                .out("leave", "q2", "take all sub");
    }

    /** Robots come to the end one by one, all together where they are stopped. */
    private static NetBuilder child() {
        return new NetBuilder("child")
                .start("c0")
                .end("ce")
                .endShared("cx")
                .transition("u0", "News")
                .in("c0", "u0", "relevant all")
                .out("u0", "ce", "take all relevant")
                .transition("u1", "Failed")
                .in("c0", "u1", "always")
                .out("u1", "cx", "take all proxy");
    }

    private static int followed(Project project, Input... inputs) throws PlanNetTooLargeException {
        return FollowedSession.firings(project, List.of("A", "B"), List.of(inputs));
    }

    @Test
    void aSubMissionOfAStartPlaceStartsWithItsMission() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent().sub("q1", "child").build(),
                child().sub("c0", "inner").build(),
                new NetBuilder("inner")
                        .start("g0")
                        .end("ge")
                        .transition("v0", "Done")
                        .in("g0", "v0", "proxy >= 1")
                        .out("v0", "ge", "take all proxy")
                        .build());

        assertThat(FollowedSession.net(project, List.of("A")).open()).hasSize(2);
        assertThat(followed(project, START, news("Other", "A"), news("Done"), news("News", "A")))
                .isEqualTo(4);
    }

    @Test
    void aSubMissionThatMakesGenericTokensBringsAllOfThemBack() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent().sub("q1", "child").build(),
                new NetBuilder("child")
                        .start("c0")
                        .end("ce")
                        .transition("u0", "News")
                        .in("c0", "u0", "relevant all")
                        .out("u0", "ce", "take all relevant", "add 3 generic")
                        .build());

        assertThat(followed(project, START, news("Other", "A"), news("News", "A")))
                .isEqualTo(3);
    }

    /** It is not taken out of the sub-mission, which has no name for it. */
    @Test
    void aGenericTokenThatAnInterruptTookComesBackAllTheSame() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                new NetBuilder("main")
                        .start("q0")
                        .places("q1")
                        .sub("q0", "child")
                        .transition("stop")
                        .input("stop", "Interrupt", Map.of("interruptName", new TextValue("stop")), Map.of())
                        .in("q0", "stop", "always")
                        .out("stop", "q1", "take all generic")
                        .transition("leave")
                        .in("q0", "leave", "always")
                        .out("leave", "q1", "take all sub")
                        .build(),
                new NetBuilder("child")
                        .start("c0")
                        .end("ce")
                        .transition("u0", "News")
                        .in("c0", "u0", "always")
                        .out("u0", "ce", "take all any")
                        .build());

        assertThat(followed(project, START, new Input.Interrupt(1, "stop", List.of()), news("News")))
                .isGreaterThanOrEqualTo(2);
    }

    @Test
    void robotsJoinASharedSubMissionAndComeBackOneByOne() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(parent().shared("q1", "child").build(), child().build());

        assertThat(FollowedSession.net(project, List.of("A")).open()).hasSize(1);
        assertThat(followed(
                        project, START, news("Other", "A"), news("Other", "B"), news("News", "B"), news("News", "A")))
                .isEqualTo(6);
    }

    @Test
    void aSharedSubMissionThatHasEndedBringsNobodyBackAnyLonger() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(parent().shared("q1", "child").build(), child().build());

        assertThat(followed(project, START, news("Other", "A"), news("Failed"), news("Other", "B"), news("News", "B")))
                .isEqualTo(4);
    }

    @Test
    void aSharedSubMissionOfASubMissionStartsWithIt() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent().sub("q1", "child").build(),
                new NetBuilder("child")
                        .start("c0")
                        .places("c1")
                        .end("ce")
                        .shared("c1", "inner")
                        .transition("u0", "News")
                        .in("c0", "u0", "relevant all")
                        .out("u0", "c1", "take all relevant")
                        .transition("u1")
                        .in("c1", "u1", "always")
                        .out("u1", "ce", "take all sub")
                        .build(),
                new NetBuilder("inner")
                        .start("g0")
                        .end("ge")
                        .transition("v0", "Done")
                        .in("g0", "v0", "relevant all")
                        .out("v0", "ge", "take all relevant")
                        .build());

        assertThat(FollowedSession.net(project, List.of("A")).open()).hasSize(2);
        assertThat(followed(project, START, news("Other", "A"), news("News", "A"), news("Done", "A")))
                .isEqualTo(5);
    }

    /** Its own transitions may fire for the visit of nobody. */
    @Test
    void nobodyEntersASharedSubMission() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent().shared("q1", "child")
                        .transition("send", "Chosen")
                        .in("q0", "send", "any >= 1")
                        .out("send", "q1", "always")
                        .build(),
                child().build());

        assertThat(followed(project, START, news("Chosen"), news("Failed"))).isGreaterThanOrEqualTo(2);
    }

    /** It is not followed any longer. */
    @Test
    void anInterruptTakesARobotOutOfASharedSubMission() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent().shared("q1", "child")
                        .transition("stop")
                        .input("stop", "Interrupt", Map.of("interruptName", new TextValue("stop")), Map.of())
                        .in("q1", "stop", "relevant >= 1")
                        .out("stop", "q0", "take all relevant")
                        .build(),
                child().build());

        assertThat(followed(
                        project,
                        START,
                        news("Other", "A"),
                        news("Other", "B"),
                        new Input.Interrupt(1, "stop", List.of("A")),
                        news("News", "B"),
                        news("Other", "A"),
                        news("News", "A")))
                .isGreaterThanOrEqualTo(6);
    }

    /** A stays in {@code q0}, so it comes a second time while it is in the sub-mission: two visits by one robot, of which the net follows the first. */
    @Test
    void aRobotVisitsAPlaceTwiceAtOnce() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(copying("add all relevant").build(), child().build());

        assertThat(FollowedSession.net(project, List.of("A")).open()).hasSize(1);
        assertThat(followed(project, START, news("Other", "A"), news("News", "A"), news("Other", "A")))
                .isEqualTo(4);
        assertThat(followed(
                        project,
                        START,
                        news("Other", "A"),
                        news("Other", "A", "B"),
                        news("News", "A"),
                        news("News", "B")))
                .isGreaterThanOrEqualTo(4);
    }

    /** Both copies are in one visit, and in one instance of the child, which brings both back. */
    @Test
    void twoCopiesOfARobotVisitAPlaceTogether() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                new NetBuilder("main")
                        .start("q0")
                        .places("q1", "q2", "q3")
                        .sub("q1", "child")
                        .transition("copy", "Chosen")
                        .in("q0", "copy", "relevant all")
                        .out("copy", "q3", "add all relevant")
                        .transition("enter", "Other")
                        .in("q3", "enter", "relevant all")
                        .out("enter", "q1", "take all relevant")
                        .transition("leave")
                        .in("q1", "leave", "always")
                        .out("leave", "q2", "take all sub")
                        .build(),
                child().build());

        assertThat(followed(
                        project,
                        START,
                        news("Chosen", "A"),
                        news("Chosen", "A"),
                        news("Other", "A"),
                        news("News", "A")))
                .isEqualTo(5);
    }

    /** Only where a robot may stand twice the net loses count: of the place with the sub-mission it does not. */
    @Test
    void aCopyThatStaysElsewhereIsInNoSubMission() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                copying("take all relevant")
                        .places("q3")
                        .out("enter", "q3", "add all relevant")
                        .transition("back", "Done")
                        .in("q2", "back", "relevant all")
                        .out("back", "q0", "take all relevant")
                        .build(),
                child().build());

        assertThat(FollowedSession.net(project, List.of("A")).open()).hasSize(1);
        assertThat(followed(
                        project,
                        START,
                        news("Other", "A"),
                        news("News", "A"),
                        news("Done", "A"),
                        news("Other", "A"),
                        news("Failed")))
                .isEqualTo(7);
    }

    private static NetBuilder copying(String entering) {
        return new NetBuilder("main")
                .start("q0")
                .places("q1", "q2")
                .sub("q1", "child")
                .transition("enter", "Other")
                .in("q0", "enter", "relevant all")
                .out("enter", "q1", entering)
                .transition("leave")
                .in("q1", "leave", "always")
                .out("leave", "q2", "take all sub");
    }
}
