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

/**
 * One event that comes to two transitions out of one place: both receive it before the first of them fires (R-OCC-6). The second one asks for no token, so it fires though the
 * first one has emptied the place (R-LOOK-7), and the net does so too.
 */
class SharedNewsTest {
    private static final Input START = new Input.StartMission("main", "m", Map.of());
    private static final Input NEWS = new Input.Received(Occurrence.news("News", List.of(), Map.of()));
    private static final Input OTHER = new Input.Received(Occurrence.news("Other", List.of("A"), Map.of()));

    /** Two transitions that wait for the same, of which the first one takes all. */
    private static NetBuilder twoThatWait(NetBuilder net, String event) {
        return waiting(waiting(net.start("p0").places("p1", "p2"), "t0", event), "t1", event)
                .in("p0", "t0", "any >= 1")
                .out("t0", "p1", "take all any")
                .in("p0", "t1", "always")
                .out("t1", "p2", "add 1 generic");
    }

    private static NetBuilder waiting(NetBuilder net, String transition, String event) {
        return event.equals("Interrupt")
                ? net.transition(transition)
                        .input(transition, event, Map.of("interruptName", new TextValue("stop")), Map.of())
                : net.transition(transition, event);
    }

    /** A mission whose sub-mission is such a plan. */
    private static NetBuilder parent(boolean isShared) {
        NetBuilder net = new NetBuilder("main").start("q0").places("q1");
        return (isShared ? net.shared("q1", "child") : net.sub("q1", "child"))
                .transition("enter", "Other")
                .in("q0", "enter", "relevant all")
                .out("enter", "q1", "take all relevant");
    }

    private static int followed(Project project, Input... inputs) throws PlanNetTooLargeException {
        return FollowedSession.firings(project, List.of("A"), List.of(inputs));
    }

    @Test
    void bothFireForOnePieceOfNews() throws PlanNetTooLargeException {
        Project project =
                NetBuilder.project(twoThatWait(new NetBuilder("main"), "News").build());

        assertThat(followed(project, START, NEWS)).isEqualTo(2);
    }

    @Test
    void bothFireForOnePress() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                twoThatWait(new NetBuilder("main"), "Interrupt").build());

        assertThat(followed(project, START, new Input.Interrupt(1, "stop", List.of())))
                .isEqualTo(2);
    }

    @Test
    void bothFireInASubMissionOfOneVisit() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent(false).build(),
                twoThatWait(new NetBuilder("child"), "News").build());

        assertThat(followed(project, START, OTHER, NEWS)).isEqualTo(3);
    }

    @Test
    void bothFireInASharedSubMission() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                parent(true).build(),
                twoThatWait(new NetBuilder("child"), "News").build());

        assertThat(followed(project, START, OTHER, NEWS)).isEqualTo(3);
    }
}
