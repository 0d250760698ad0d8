package org.sami.crw.gui.context;

import java.util.List;
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

/** What a window shows: a session that runs, or the replay of one, in which nothing acts. */
public interface ShownSession {
    /** What lies before the operator, or lay. */
    OperatorModels models();

    /** The words of the session. */
    Vocabulary vocabulary();

    /** The project with which it began. */
    Project project();

    /** The moment that is shown, in ms of the session's clock. */
    long nowMillis();

    /** Asks the engine's state; what it says arrives on the event thread. */
    <T> CompletionStage<T> ask(Function<EngineView, T> question);

    /**
     * Finds the way on which a boat would go along a path for a mission from where it is: with the turns around what is to be avoided. Empty where that is
     * not known; arrives on the event thread.
     */
    CompletionStage<Optional<List<GeoPoint>>> way(long mission, String boat, GeoPath path);

    /**
     * The paths of the boats that wait for the answer to a decision about their ways. Empty where that is not known, as in a replay; arrives on the
     * event thread.
     */
    CompletionStage<Optional<DoubtedPaths>> doubtedPaths(Decision decision);

    /** Tells a listener of the engine's steps, on the thread on which they are taken. */
    void addListener(HostListener listener);

    /** Goes to a moment, where what is shown is a replay; empty where it is a session, whose moment is now. */
    Optional<LongConsumer> moments();

    /** The session, if it runs, here or in another process. */
    Optional<FrontSession> session();
}
