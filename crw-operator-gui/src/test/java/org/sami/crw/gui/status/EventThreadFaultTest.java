package org.sami.crw.gui.status;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.SessionWorld.until;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.session.Session;
import org.sami.ui.EventThread;

/** What is thrown on the event thread of a window whose program has the session's guard. */
@Timeout(900)
class EventThreadFaultTest {
    @AfterEach
    void guardNoLonger() {
        Thread.setDefaultUncaughtExceptionHandler(null);
    }

    private static boolean isIn(Session session, HealthKind kind) {
        return !session.models().health().snapshot().of(kind).isEmpty();
    }

    @Test
    void anExceptionIsSaidAndMemoryThatRunsOutEndsTheSessionInWordsWhileTheThreadLivesOn() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            Thread.setDefaultUncaughtExceptionHandler(world.session.faults().guard());
            EventThread.later(() -> {
                throw new IllegalStateException("a gap");
            });
            until("the exception is said", () -> isIn(world.session, HealthKind.THREAD));
            assertThat(world.session.faults().failure()).isEmpty();

            EventThread.later(() -> {
                throw new OutOfMemoryError("Java heap space");
            });
            until("the session has ended", () -> isIn(world.session, HealthKind.ENGINE));
            assertThat(world.session.faults().failure().orElseThrow())
                    .startsWith("memory ran out (Java heap space) on the thread 'AWT-EventQueue");
            assertThat(SessionWorld.get(world.session.fleet().stopAll())).containsExactly("anna");
        }
    }
}
