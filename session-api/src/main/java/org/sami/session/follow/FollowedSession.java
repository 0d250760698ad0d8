package org.sami.session.follow;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.FollowFeed;
import org.sami.crw.operator.OperatorModels;
import org.sami.session.api.BoatStart;
import org.sami.session.record.LostLinkWishRows;
import org.sami.session.record.SessionPictures;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostState;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.ListenerList;
import org.sami.spn.host.Registration;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Shows a session that runs in another process: models and an engine of its own, to which that session's inputs and telemetry are given as they come. Equal inputs make
 * equal states, so that the engine here answers every question as the one there does. Nothing acts.
 *
 * <p>For one thread of the follower's, but {@link #models}, {@link #addListener} and {@link #lostLinkWish}, which are for any.
 */
public final class FollowedSession {
    private static final long SECOND_MS = 1000;

    private final Engine engine;
    private final OperatorModels models;
    private final LongSupplier nowMillis;
    private final FollowFeed feed;
    private final RecordedBoats boats;
    private final ListenerList<HostListener> listeners = new ListenerList<>();
    private EngineState state;
    private long index;
    private long tickedMillis;
    private boolean stepped;
    private volatile Optional<LostLinkAction> lostLinkWish = Optional.empty();

    /**
     * A session of which nothing is known yet but its plans.
     *
     * @param owner of the models
     * @param nowMillis the session's clock
     * @param computing computes what sensors measured for the map, one after the other
     * @param pictures where pictures are here before their rows are taken
     */
    public FollowedSession(
            Vocabulary vocabulary,
            Project project,
            Executor owner,
            LongSupplier nowMillis,
            Executor computing,
            FollowFeed.Acknowledgements acknowledge,
            SessionPictures pictures) {
        this.nowMillis = nowMillis;
        engine = new Engine(vocabulary, project);
        state = engine.newState();
        models = new OperatorModels(owner, nowMillis, computing, HandlerModules.robotsOf(vocabulary));
        feed = models.followFeed(acknowledge);
        boats = new RecordedBoats(feed.boats(), message -> {}, Optional.of(pictures)); // messages come as a list
    }

    /** What lies before the operator. */
    public OperatorModels models() {
        return models;
    }

    /** What only the session itself can find out. */
    public FollowFeed feed() {
        return feed;
    }

    /** The words of the session. */
    public Vocabulary vocabulary() {
        return engine.vocabulary();
    }

    /** The project with which it began. */
    public Project project() {
        return engine.project();
    }

    /** Adds a listener to the steps of the engine here. */
    public Registration addListener(HostListener listener) {
        return listeners.add(listener);
    }

    /**
     * Begins, or begins again, with a state.
     *
     * @param documents of loaded projects, by their SHA-256
     * @param rows what is to be known of boats and of the operator's log
     * @throws IllegalArgumentException in words, if this program cannot read the state
     */
    public void begin(HostState from, Map<String, String> documents, List<TelemetryRow> rows) {
        EngineState read =
                StateCodec.decode(from.state(), engine, sha256 -> Optional.ofNullable(documents.get(sha256)));
        state = read;
        index = from.index();
        boats.clear();
        feed.boats().hold();
        feed.begin(engine.view(state), nowMillis.getAsLong());
        lostLinkWish = LostLinkWishRows.after(rows, Optional.empty());
        rows.forEach(boats::take);
        stepped = true;
        look();
        feed.boats().release();
    }

    /** An input of the session; one that is known already changes nothing. */
    public void take(JournalEntry entry) {
        if (entry.index() <= index) {
            return;
        }
        if (entry.index() != index + 1) {
            throw new IllegalStateException("input " + (index + 1) + " is missing before " + entry.index());
        }
        index = entry.index();
        List<Effect> effects = engine.step(state, entry.atMillis(), entry.input());
        EngineView view = engine.view(state);
        models.onPastStep(entry.atMillis(), entry.input(), effects, view);
        listeners.each(listener -> listener.onStep(entry.index(), entry.atMillis(), entry.input(), effects, view));
        stepped = true;
    }

    /** What the session noted of a boat, or of its operators. */
    public void take(TelemetryRow row) {
        lostLinkWish = LostLinkWishRows.after(List.of(row), lostLinkWish);
        boats.take(row);
    }

    /** What the session wishes that its boats do when their link is lost; empty where it wishes nothing, or does not say it. */
    public Optional<LostLinkAction> lostLinkWish() {
        return lostLinkWish;
    }

    /** What it knows of a boat now. */
    public void take(BoatSample sample) {
        boats.sample(sample);
    }

    /** It has that boat no longer. */
    public void gone(String boat) {
        boats.gone(boat);
    }

    /** Shows what changes by itself, and what the engine says when it is asked. To be called a few times a second. */
    public void look() {
        if (stepped) {
            stepped = false;
            feed.boats().look(engine.view(state), engine.vocabulary());
        }
        long now = nowMillis.getAsLong();
        if (now - tickedMillis >= SECOND_MS) {
            tickedMillis = now;
            feed.boats().tick(now);
        }
        feed.boats().draw(now);
    }

    /** Asks the engine's state. */
    public <T> T ask(Function<EngineView, T> question) {
        return question.apply(engine.view(state));
    }

    /** What a way of a boat depends on; empty where that is not known. */
    public Optional<BoatStart> start(String boat) {
        return boats.start(boat);
    }
}
