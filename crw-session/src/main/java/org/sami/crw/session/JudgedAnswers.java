package org.sami.crw.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.judgement.AnswerJudge;
import org.sami.crw.judgement.JudgedBoat;
import org.sami.crw.judgement.JudgedQuestion;
import org.sami.crw.judgement.QuestionReader;
import org.sami.crw.judgement.StartReader;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.DraftJudge;
import org.sami.session.api.Judgement;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.Value;

/**
 * Judges drafts of answers, and values before they are set, by the present state of engine and boats; computes on a thread of its own. From any
 * thread.
 */
public final class JudgedAnswers implements DraftJudge {
    private final Fleet fleet;
    private final SessionEngine engine;
    private final Executor computing;
    private final CrwServices services;
    private final AnswerJudge judge;
    private final RobotKind robots;

    /**
     * Judges for one session.
     *
     * @param computing finds ways
     * @param robots what judgements speak of
     */
    JudgedAnswers(Fleet fleet, SessionEngine engine, CrwServices services, Executor computing, RobotKind robots) {
        this.robots = robots;
        this.fleet = fleet;
        this.engine = engine;
        this.services = services;
        this.computing = computing;
        judge = new AnswerJudge(services);
    }

    /** Judges a draft of an answer: what of it cannot be, what boats are not to enter, and what it takes. */
    @Override
    public CompletionStage<Judgement> judge(Decision decision, DraftAnswer draft) {
        return engine.ask(view -> QuestionReader.read(decision, view))
                .thenCompose(read -> read.map(question -> judge(question, draft))
                        .orElse(CompletableFuture.completedFuture(Judgement.NOTHING)));
    }

    /**
     * Judges values with which a mission of a plan is to start, as answers are.
     *
     * @param values by the names of parameters, as {@link Session#start} takes them
     */
    @Override
    public CompletionStage<Judgement> judgeStart(String plan, Map<String, Value> values) {
        return engine.ask(view -> StartReader.plan(plan, values.keySet(), view))
                .thenCompose(read -> read.map(question -> judge(question, DraftAnswer.of(values)))
                        .orElse(CompletableFuture.completedFuture(Judgement.NOTHING)));
    }

    /** Judges a value that a global is to have: what of it cannot be, and where boats are not to enter. */
    @Override
    public CompletionStage<Judgement> judgeGlobal(String name, Value value) {
        return engine.ask(view -> StartReader.global(name, view))
                .thenCompose(question -> judge(question, DraftAnswer.of(Map.of(name, value))));
    }

    private CompletionStage<Judgement> judge(JudgedQuestion question, DraftAnswer draft) {
        return fleet.ask(known -> boats(known, question.boats(draft)))
                .thenCompose(boats -> engine.replies()
                        .on(computing, () -> judge.judge(question, boats, draft).inWordsFor(robots)));
    }

    private List<JudgedBoat> boats(ProxyRegistry known, List<String> names) {
        return names.stream()
                .map(known::find)
                .flatMap(Optional::stream)
                .map(this::judged)
                .toList();
    }

    private JudgedBoat judged(BoatProxy boat) {
        return new JudgedBoat(
                boat.boatId(),
                boat.status().pose().map(BoatPose::position),
                boat.charge(),
                boat.home(),
                boat.errorOr(services.error()),
                boat.cruiseSpeedMps(),
                boat.turningRadiusM(),
                boat.capabilities());
    }
}
