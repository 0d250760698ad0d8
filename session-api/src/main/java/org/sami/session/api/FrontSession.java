package org.sami.session.api;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.operator.OperatorModels;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.Registration;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a front may see of a session, ask of it and do in it, wherever the session runs: in this process ({@code org.sami.crw.session.Session}), or in another
 * ({@code org.sami.session.client}). Says nothing of how it is reached.
 *
 * <p>Methods may be called from any thread and return at once; what comes of them arrives on the front's executor, a refusal as a {@link RefusedException}.
 */
public interface FrontSession {
    /** What lies before the operator; belongs to the front's executor. */
    OperatorModels models();

    /** The words of the session. */
    Vocabulary vocabulary();

    /** The project with which the session began. */
    Project firstProject();

    /** The session's time in ms. */
    long nowMillis();

    /** Asks the engine's state. */
    <T> CompletionStage<T> ask(Function<EngineView, T> question);

    /** Completes when the models have all that followed until now, also from handlers, a little after the engine's step. */
    CompletionStage<Void> caughtUp();

    /** Adds a listener to the engine's steps; called on the engine's thread, must be quick. */
    Registration addListener(HostListener listener);

    /** Finds the way on which a boat would go along a path for a mission now. Empty for a boat of which it is not known where it is. */
    CompletionStage<Optional<List<GeoPoint>>> way(long mission, String boat, GeoPath path);

    /** The paths of the boats that wait for the answer to a decision about their ways; empty where it is about something else, or that is not known here. */
    CompletionStage<Optional<DoubtedPaths>> doubtedPaths(Decision decision);

    /** Starts a mission; values by the names of parameters. Gives its id. */
    CompletionStage<Long> start(String plan, String name, Map<String, Value> parameters);

    /** Aborts a mission: its boats stop doing what it asked. */
    CompletionStage<Void> abort(long mission);

    /** Aborts all missions. */
    CompletionStage<Void> abortAll();

    /** Completes a mission. */
    CompletionStage<Void> complete(long mission);

    /** Presses an interrupt of a mission, or of every mission that offers it ({@code Ids.NONE}). */
    CompletionStage<Void> press(String interrupt, long mission, List<String> boats);

    /** Answers a decision. The first answer counts; a later one is refused. */
    CompletionStage<Void> answer(long decision, Answer answer, String by);

    /** Judges drafts of answers and values. */
    DraftJudge drafts();

    /** What an operator wants of boats without a plan. */
    GuidedBoats byHand();

    /**
     * Answers a decision, unless the judgement of the answer refuses it. The first answer counts; a later one is refused.
     *
     * @param by name of the operator; of a session that knows who asks, that person counts
     * @return what is doubtful about the answer
     */
    CompletionStage<List<String>> answerJudged(Decision decision, Answer answer, String by);

    /** Stops the timer of a decision: autonomy does not answer it any longer. */
    CompletionStage<Void> hold(long decision);

    /** Asks once more of boats and services what failed for a mission. */
    CompletionStage<Void> sendAgain(long mission);

    /** Writes a variable as a mission would; {@code Ids.NONE} writes a global one. */
    CompletionStage<Void> setVariable(long mission, String variable, Value value);

    /** Takes a boat out of one mission. */
    CompletionStage<Void> drop(String boat, long mission);

    /** Takes a boat out of all missions and disconnects it. */
    CompletionStage<Void> drop(String boat);

    /** Gives a task to another boat, or to nobody. */
    CompletionStage<Void> moveTask(TaskId task, Optional<String> boat);

    /** Writes something down in the operator's log, maybe about a place. */
    CompletionStage<Void> addNote(String text, Optional<GeoPoint> position);

    /** The boats. */
    FrontFleet fleet();
}
