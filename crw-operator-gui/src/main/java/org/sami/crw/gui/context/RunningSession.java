package org.sami.crw.gui.context;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.LongConsumer;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.operator.OperatorModels;
import org.sami.session.api.FrontSession;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/** A session that runs, as a window shows it. */
public record RunningSession(FrontSession running) implements ShownSession {
    public RunningSession {
        Objects.requireNonNull(running, "session");
    }

    @Override
    public OperatorModels models() {
        return running.models();
    }

    @Override
    public Vocabulary vocabulary() {
        return running.vocabulary();
    }

    @Override
    public Project project() {
        return running.firstProject();
    }

    @Override
    public long nowMillis() {
        return running.nowMillis();
    }

    @Override
    public <T> CompletionStage<T> ask(Function<EngineView, T> question) {
        return running.ask(question);
    }

    @Override
    public CompletionStage<Optional<List<GeoPoint>>> way(long mission, String boat, GeoPath path) {
        return running.way(mission, boat, path);
    }

    @Override
    public CompletionStage<Optional<DoubtedPaths>> doubtedPaths(Decision decision) {
        return running.doubtedPaths(decision);
    }

    @Override
    public void addListener(HostListener listener) {
        running.addListener(listener);
    }

    @Override
    public Optional<LongConsumer> moments() {
        return Optional.empty();
    }

    @Override
    public Optional<FrontSession> session() {
        return Optional.of(running);
    }
}
