package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.operator.ClickCount;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.sim.report.DecisionResult;
import org.sami.crw.sim.report.FiringResult;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RowFormats;
import org.sami.crw.sim.report.SpooledList;
import org.sami.crw.sim.report.TaskResult;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;

/** Notes down what the engine does, for the report and for the hash of the run. One root mission is the run's. */
public final class RunRecorder implements HostListener {
    private final Project project;
    private final RunHash hash = new RunHash();
    private final Map<Long, String> planOfMission = new LinkedHashMap<>();
    private final SpooledList<FiringResult> firings = new SpooledList<>(RowFormats.FIRING);
    private final Map<Long, Question> openDecisions = new LinkedHashMap<>();
    private final SpooledList<DecisionResult> settled = new SpooledList<>(RowFormats.DECISION);
    private final Map<Long, DecisionResult> decisions = new LinkedHashMap<>(); // from the first that is open
    private final List<NoteResult> notes = new ArrayList<>();
    private final TaskRecorder tasks;
    private OptionalLong root = OptionalLong.empty();
    private Optional<Outcome> outcome = Optional.empty();
    private OptionalLong endedAtMillis = OptionalLong.empty();
    private Optional<String> failure = Optional.empty();
    private int boatsJoined;
    private long lastInputMillis;

    /** A recorder of a run of one of the project's plans. */
    public RunRecorder(Project project) {
        this.project = project;
        tasks = new TaskRecorder(project);
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        lastInputMillis = atMillis;
        tasks.onStep(atMillis, input, effects, view);
        boatsJoined += input instanceof Input.ProxyJoined ? 1 : 0;
        hash.add(atMillis, effects);
        for (Effect effect : effects) {
            take(index, atMillis, input, effect);
        }
        if (input instanceof Input.StartMission && root.isEmpty()) {
            failure = Optional.of(
                    notes.isEmpty()
                            ? "the mission did not start"
                            : notes.get(notes.size() - 1).message());
        }
    }

    @Override
    public void onFailed(String reason) {
        failure = Optional.of(reason);
    }

    private void take(long index, long atMillis, Input input, Effect effect) {
        if (effect instanceof Effect.MissionStarted started) {
            planOfMission.put(started.mission(), started.plan());
            if (started.parent() == Ids.NONE && root.isEmpty()) {
                root = OptionalLong.of(started.mission());
            }
        } else if (effect instanceof Effect.Fired fired) {
            firings.add(firing(index, atMillis, fired));
        } else if (effect instanceof Effect.DecisionOpened opened) {
            opened(atMillis, opened.decision());
        } else if (effect instanceof Effect.DecisionClosed closed) {
            closed(atMillis, closed);
        } else if (effect instanceof Effect.Noted noted) {
            noted(atMillis, input, noted);
        } else if (effect instanceof Effect.MissionEnded ended) {
            ended(atMillis, ended);
        }
    }

    private void ended(long atMillis, Effect.MissionEnded ended) {
        if (isRoot(ended.mission())) {
            outcome = Optional.of(ended.outcome());
            endedAtMillis = OptionalLong.of(atMillis);
        }
        if (ended.outcome() != Outcome.HALTED) {
            planOfMission.remove(ended.mission()); // it never fires again
        }
    }

    private boolean isRoot(long mission) {
        return root.isPresent() && root.getAsLong() == mission;
    }

    private FiringResult firing(long index, long atMillis, Effect.Fired fired) {
        String planId = planOfMission.getOrDefault(fired.mission(), "");
        Optional<Plan> plan = project.plan(planId);
        return new FiringResult(
                fired.firing(),
                index,
                atMillis,
                fired.mission(),
                planId,
                plan.map(known -> EngineText.transition(known, fired.transition()))
                        .orElse(fired.transition()),
                EngineText.occurrences(fired.used()),
                plan.map(known -> EngineText.moves(known, fired.moves())).orElse(""));
    }

    private void opened(long atMillis, Decision decision) {
        openDecisions.put(decision.id(), decision.question());
        decisions.put(
                decision.id(),
                new DecisionResult(
                        decision.id(),
                        decision.mission(),
                        decision.type(),
                        decision.prompt(),
                        atMillis,
                        OptionalLong.empty(),
                        "",
                        "",
                        0));
    }

    private void closed(long atMillis, Effect.DecisionClosed closed) {
        Question question = openDecisions.remove(closed.decision());
        DecisionResult open = decisions.get(closed.decision());
        if (question == null || open == null) {
            return;
        }
        decisions.put(
                closed.decision(),
                new DecisionResult(
                        open.id(),
                        open.mission(),
                        open.type(),
                        open.prompt(),
                        open.openedAtMillis(),
                        OptionalLong.of(atMillis),
                        closed.by()
                                .map(who -> who.name().toLowerCase(Locale.ROOT))
                                .orElse(""),
                        closed.answer().map(EngineText::answer).orElse(""),
                        closed.by().equals(Optional.of(Answerer.OPERATOR))
                                ? closed.answer()
                                        .map(answer -> (int) ClickCount.ofAnswer(answer, question))
                                        .orElse(0)
                                : 0));
        settle();
    }

    /** In the order in which they were opened, those before the first that is open are told from a file. */
    private void settle() {
        Iterator<DecisionResult> oldest = decisions.values().iterator();
        while (oldest.hasNext()) {
            DecisionResult decision = oldest.next();
            if (decision.closedAtMillis().isEmpty()) {
                return;
            }
            settled.add(decision);
            oldest.remove();
        }
    }

    private void noted(long atMillis, Input input, Effect.Noted noted) {
        String kind = noted.kind() == NoteKind.DISCARDED && !isAnswer(input)
                ? NoteResult.NEWS
                : noted.kind().name().toLowerCase(Locale.ROOT);
        notes.add(new NoteResult(atMillis, kind, noted.mission(), noted.message()));
        if (noted.kind() == NoteKind.LIVELOCK && isRoot(noted.mission())) {
            outcome = Optional.of(Outcome.HALTED);
            endedAtMillis = OptionalLong.of(atMillis);
        }
    }

    /** Whether somebody was asked for it. Of news, and of a press that is refused, nobody misses what no transition takes. */
    private static boolean isAnswer(Input input) {
        return !(input instanceof Input.Interrupt)
                && !(input instanceof Input.Received received
                        && received.occurrence().activation() == Ids.NONE);
    }

    /** How the run's mission ended; empty while it goes on. */
    public Optional<Outcome> outcome() {
        return outcome;
    }

    /** When the run's mission ended; empty while it goes on. */
    public OptionalLong endedAtMillis() {
        return endedAtMillis;
    }

    /** Why the run cannot go on, in one sentence; empty while it can. */
    public Optional<String> failure() {
        return failure;
    }

    /** The run's mission, empty before it started. */
    public OptionalLong root() {
        return root;
    }

    RunHash hash() {
        return hash;
    }

    /** When the engine last took something in. */
    public long lastInputMillis() {
        return lastInputMillis;
    }

    /** How many boats the engine has got to know. */
    public int boatsJoined() {
        return boatsJoined;
    }

    /** How many firings there were. */
    public int firingCount() {
        return firings.size();
    }

    /** All firings so far, in order. */
    public List<FiringResult> firings() {
        return firings.soFar();
    }

    /** All decisions so far, in the order in which they were asked. */
    public List<DecisionResult> decisions() {
        List<DecisionResult> all = new ArrayList<>(settled);
        all.addAll(decisions.values());
        return all;
    }

    /** What became of tasks so far. */
    public List<TaskResult> tasks() {
        return tasks.results();
    }

    /** What the engine noted so far. */
    public List<NoteResult> notes() {
        return notes;
    }
}
