package org.sami.crw.session;

import java.io.Closeable;
import java.io.IOException;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostListener;

/** The engine of a session with its host, those who wait for results of their inputs, and the operators. */
final class SessionEngine implements Closeable {
    private final Engine engine;
    private final SessionJournal journal;
    private final EngineHost host;
    private final Replies replies;
    private final PostedInputs posted;
    private final Operators operators = new Operators();
    private boolean replayed; // before it begins

    /** An engine at the state to which the journal came. */
    SessionEngine(SessionSetup setup, SessionThreads threads) throws IOException {
        journal = setup.journal();
        engine = new Engine(setup.vocabulary(), setup.project());
        host = EngineHostBuilder.of(engine, journal.restore(engine))
                .journal(journal.inputs())
                .clock(new ScheduledHostClock(threads.scheduler()))
                .executor(threads.engine())
                .slowListenerMillis(threads.slowMillis())
                .journalRetryMillis(setup.onFault().patienceMillis())
                .build();
        replies = new Replies(threads.front());
        posted = new PostedInputs(host, replies);
    }

    EngineHost host() {
        return host;
    }

    Replies replies() {
        return replies;
    }

    PostedInputs posted() {
        return posted;
    }

    Operators operators() {
        return operators;
    }

    /** Asks the engine's state; the answer arrives where results do. */
    <T> CompletionStage<T> ask(Function<EngineView, T> question) {
        return replies.of(host.query(question));
    }

    /** From now on the operators hear of each step, then the models, then those who wait for a result. */
    void listen(OperatorModels models) {
        host.addListener(operators);
        host.addListener(models);
        host.addListener(posted);
    }

    /** Replays the steps of earlier processes to a listener, the models and the operators. */
    void replay(HostListener listener, OperatorModels models) throws IOException {
        replayed = true;
        journal.replay(engine, (index, atMillis, input, effects, view) -> {
            listener.onStep(index, atMillis, input, effects, view);
            models.onPastStep(atMillis, input, effects, view);
            operators.onStep(index, atMillis, input, effects, view);
        });
    }

    /** Takes up what was open, and takes inputs in. */
    void begin(OperatorModels models, long nowMillis) {
        host.ask(view -> {
            operators.restore(view, nowMillis);
            models.restoreAreas(view);
            if (!replayed) { // else the models have heard it
                models.restore(view, nowMillis);
            }
            return null;
        });
        host.resume();
    }

    @Override
    public void close() {
        host.close();
        replies.close();
    }
}
