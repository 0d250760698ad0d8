package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.context.MarksOfBoats;
import org.sami.crw.gui.context.RunningSession;
import org.sami.palette.ProxyMarks;

@Timeout(900)
class MarksOfBoatsTest {
    @Test
    void boatsHaveTheSameMarksWhetherAWindowSawThemJoinOrNot() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "carl", "anna", "bert")) {
            ProxyMarks fromTheStart = new ProxyMarks();
            ProxyMarks later = new ProxyMarks();
            onEventThread(() -> {
                fromTheStart.of("carl"); // it was seen first
                MarksOfBoats.give(new RunningSession(world.session), fromTheStart);
                return null;
            });
            world.start("clv");
            onEventThread(() -> {
                MarksOfBoats.give(new RunningSession(world.session), later);
                return null;
            });

            for (ProxyMarks marks : new ProxyMarks[] {fromTheStart, later}) {
                SessionWorld.until(
                        "the boats have their marks",
                        () -> onEventThread(() -> marks.of("carl").index() == 2
                                && marks.of("bert").index() == 1));
                assertThat(onEventThread(() -> marks.of("anna").index())).isZero();
            }
        }
    }
}
