package org.sami.crw.console;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.session.Session;
import org.sami.session.api.FrontSession;
import org.sami.session.api.RefusedException;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.Registration;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What commands work on: the session, and waiting for what comes of them. Belongs to the console's thread, which is none of the
 * session's and may wait.
 */
final class ConsoleContext implements AutoCloseable {
    private static final long LONGEST_REPLY_S = 30;

    private final FrontSession session;
    private final Vocabulary vocabulary;
    private final ConsoleWords words;
    private final Object changed = new Object();
    private List<Registration> registrations = List.of();
    private volatile boolean ended;

    ConsoleContext(FrontSession session) {
        this.session = Objects.requireNonNull(session, "session");
        vocabulary = session.vocabulary();
        words = new ConsoleWords(HandlerModules.robotsOf(vocabulary));
    }

    /** Begins to hear of changes; after those whose lines are to stand before what a wait's end allows. */
    void listen() {
        OperatorModels models = session.models();
        registrations = List.of(
                models.decisions().addListener(snapshot -> wake()),
                models.missions().addListener(snapshot -> wake()),
                models.allocation().addListener(snapshot -> wake()),
                models.alarms().addListener(snapshot -> wake()),
                models.fleet().addListener(snapshot -> wake()));
    }

    /** Nothing is waited for any longer. From any thread. */
    void end() {
        ended = true;
        wake();
    }

    private void wake() {
        synchronized (changed) {
            changed.notifyAll();
        }
    }

    FrontSession session() {
        return session;
    }

    /**
     * The session itself, for what only its own machine has.
     *
     * @param what is there only, for the fault
     */
    Session inProcess(String what) {
        return Session.inProcess(session)
                .orElseThrow(() -> new ConsoleFault("not from here: " + what + " the machine of the session"));
    }

    OperatorModels models() {
        return session.models();
    }

    Vocabulary vocabulary() {
        return vocabulary;
    }

    /** How the console speaks of the session's robots. */
    ConsoleWords words() {
        return words;
    }

    /** The newest project: that with which the session began, or the last that was loaded. */
    Project project() {
        return await(session.ask(EngineView::project));
    }

    /** A plan by its id or name. */
    Plan plan(String name) {
        return project().plans().stream()
                .filter(plan -> plan.id().equals(name) || plan.name().equals(name))
                .findFirst()
                .orElseThrow(() ->
                        new ConsoleFault("there is no plan '" + name + "'; there are " + String.join(", ", plans())));
    }

    List<String> plans() {
        return project().plans().stream().map(Plan::id).toList();
    }

    /** The ids of the boats that are known. */
    List<String> boats() {
        return models().fleet().snapshot().stream().map(BoatSnapshot::boat).toList();
    }

    /** The numbers of the missions that run and were started by themselves. */
    List<String> missions() {
        return models().missions().snapshot().running().stream()
                .map(MissionSnapshot::id)
                .map(String::valueOf)
                .toList();
    }

    /** Waits until all results of the engine's steps are printed: also messages of handlers, a little after the engine's step. */
    void catchUp() {
        await(session.caughtUp());
    }

    /**
     * Waits for what a stage gives.
     *
     * @throws ConsoleFault if it is refused, or takes more than 30 s
     */
    <T> T await(CompletionStage<T> stage) {
        return await(stage, LONGEST_REPLY_S);
    }

    /** As the other, with a time in seconds. */
    <T> T await(CompletionStage<T> stage, double seconds) {
        try {
            return stage.toCompletableFuture().get((long) (seconds * 1000), TimeUnit.MILLISECONDS);
        } catch (ExecutionException refused) {
            throw new ConsoleFault(RefusedException.reason(Objects.requireNonNullElse(refused.getCause(), refused)));
        } catch (TimeoutException late) {
            throw new ConsoleFault("no answer within " + Numbers.short1(seconds) + " s; it goes on being tried");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new ConsoleFault("interrupted");
        }
    }

    /** Waits until something is so; looked at whenever a model changes. Gives whether it is. */
    boolean until(BooleanSupplier wanted, double seconds) {
        long end = System.nanoTime() + (long) (seconds * 1e9);
        synchronized (changed) {
            while (!wanted.getAsBoolean()) {
                if (ended) {
                    throw new ConsoleFault("it is waited for no longer");
                }
                long leftMillis = (end - System.nanoTime()) / 1_000_000;
                if (leftMillis <= 0) {
                    return false;
                }
                try {
                    changed.wait(leftMillis);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                    throw new ConsoleFault("interrupted");
                }
            }
            return true;
        }
    }

    @Override
    public void close() {
        registrations.forEach(Registration::close);
    }
}
