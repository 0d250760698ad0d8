package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.lang.reflect.Proxy;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.context.MarksOfBoats;
import org.sami.crw.gui.context.RunningSession;
import org.sami.crw.gui.context.ShownSession;
import org.sami.palette.ProxyMarks;
import org.sami.ui.EventThread;

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

    @Test
    void missionThatStartsBeforeTheStateOfTheSessionArrivesDecidesTheOrderOfItsBoats() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "carl", "anna", "bert")) {
            ShownSession running = new RunningSession(world.session);
            CompletableFuture<Void> arrives = new CompletableFuture<>();
            ShownSession slow = (ShownSession) Proxy.newProxyInstance(
                    getClass().getClassLoader(), new Class<?>[] {ShownSession.class}, (proxy, method, given) -> {
                        Object answer = method.invoke(running, given);
                        return answer instanceof CompletionStage<?> asked
                                ? arrives.thenCombine(asked, (now, state) -> state)
                                : answer;
                    });
            ProxyMarks marks = new ProxyMarks();
            CountDownLatch started = new CountDownLatch(1);
            onEventThread(() -> {
                MarksOfBoats.give(slow, marks);
                return null;
            });
            running.addListener((index, atMillis, input, effects, view) -> EventThread.later(started::countDown));
            world.start("clv");
            Await.latch(started); // the step has reached the event thread

            onEventThread(() -> arrives.complete(null));

            assertThat(onEventThread(() -> List.of(
                            marks.of("anna").index(),
                            marks.of("bert").index(),
                            marks.of("carl").index())))
                    .containsExactly(0, 1, 2);
        }
    }
}
