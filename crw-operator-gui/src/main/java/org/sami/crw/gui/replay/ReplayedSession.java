package org.sami.crw.gui.replay;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.LongConsumer;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.gui.context.ShownSession;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.replay.Replay;
import org.sami.session.api.FrontSession;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.EventThread;

/**
 * A replay, as a window shows it.
 *
 * @param worker the replay's thread
 * @param computing computes what is only to be drawn
 * @param goTo goes to a moment
 */
record ReplayedSession(Replay replay, Executor worker, Executor computing, LongConsumer goTo) implements ShownSession {
    @Override
    public OperatorModels models() {
        return replay.models();
    }

    @Override
    public Vocabulary vocabulary() {
        return replay.journal().vocabulary();
    }

    @Override
    public Project project() {
        return replay.journal().project();
    }

    @Override
    public long nowMillis() {
        return replay.shownMillis();
    }

    @Override
    public <T> CompletionStage<T> ask(Function<EngineView, T> question) {
        return CompletableFuture.supplyAsync(() -> replay.ask(question), worker)
                .thenApplyAsync(answer -> answer, EventThread.executor());
    }

    @Override
    public CompletionStage<Optional<List<GeoPoint>>> way(long mission, String boat, GeoPath path) {
        return CompletableFuture.supplyAsync(() -> replay.start(boat), worker)
                .thenCombineAsync(
                        CompletableFuture.supplyAsync(() -> replay.ask(view -> WayLimits.of(mission, view)), worker),
                        (start, limits) -> start.map(one -> one.way(path, limits)),
                        computing)
                .thenApplyAsync(way -> way, EventThread.executor());
    }

    /** Which boats waited, and where they were to go, no journal says. */
    @Override
    public CompletionStage<Optional<DoubtedPaths>> doubtedPaths(Decision decision) {
        return CompletableFuture.completedFuture(Optional.empty());
    }

    @Override
    public void addListener(HostListener listener) {
        replay.addListener(listener);
    }

    @Override
    public Optional<LongConsumer> moments() {
        return Optional.of(goTo);
    }

    @Override
    public Optional<FrontSession> session() {
        return Optional.empty();
    }
}
