package org.sami.crw.gui.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.replay.Replay;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.session.Session;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** The ways of an option are drawn in a replay as they were in the session. */
@Timeout(900)
class ReplayedWayTest {
    /** From the quay of Katara Beach a rock lies before it. */
    private static final GeoPoint BEHIND = GeoPoint.of(25.3615, 51.532);

    @TempDir
    private Path folder;

    @Test
    void wayOfAPathLeadsInAReplayAroundWhatItLedAroundInTheSession() throws Exception {
        GeoPath path = new GeoPath(List.of(BEHIND));
        try (DataDirectory data = DataDirectory.open(folder);
                Session session = new SessionOpener(data, List.of(), Optional.empty()).openNew()) {
            session.begin();
            Path journal = data.unfinished().orElseThrow();
            Await.until(
                    "the journal has where anna is, and how far it may be beside its ways",
                    () -> replay(journal)
                            .start("anna")
                            .filter(start -> start.error().equals(CrossTrackError.CALM))
                            .isPresent());
            Replay replay = replay(journal);
            List<GeoPoint> then = soon(session.way(Ids.NONE, "anna", path)).orElseThrow();
            ReplayedSession shown = new ReplayedSession(replay, Runnable::run, Runnable::run, at -> {});

            List<GeoPoint> now = soon(shown.way(Ids.NONE, "anna", path)).orElseThrow();

            assertThat(then).hasSizeGreaterThan(2);
            assertThat(now).hasSameSizeAs(then);
            for (int i = 0; i < now.size(); i++) {
                assertThat(Geodesy.distanceM(now.get(i), then.get(i))).isLessThan(1);
            }
        }
    }

    private static Replay replay(Path journal) {
        try {
            Replay replay = new Replay(ReplayedJournal.open(journal), Runnable::run, Runnable::run);
            replay.goTo(Long.MAX_VALUE);
            return replay;
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static <T> T soon(CompletionStage<T> stage) {
        return stage.toCompletableFuture().orTimeout(300, TimeUnit.SECONDS).join();
    }
}
