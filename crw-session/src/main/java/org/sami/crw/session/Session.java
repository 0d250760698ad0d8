package org.sami.crw.session;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.operator.OperatorModels;
import org.sami.session.api.BoatStart;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.FrontSession;
import org.sami.session.api.RefusedException;
import org.sami.session.record.SessionTelemetry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.Registration;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Runs plans on boats: the engine's host, the domain, the links to boats, the journal and the operator's models together. A window, a
 * console, {@code crw run} and a test use it alike (docs/session.md).
 *
 * <p>It opens with no boat and no mission, at the state to which its journal came. Listeners and operators are added, and boats may be
 * connected, before {@link #begin}; from then on any number of missions run, and boats come and go.
 *
 * <p>Methods may be called from any thread and return at once, but where said. What comes of them arrives on the front's executor: a
 * value, or a {@link RefusedException} that says why not. Neither the engine's nor the fleet's thread ever waits for a listener.
 */
public final class Session implements FrontSession, AutoCloseable {
    private final SessionSetup setup;
    private final SessionParts parts;
    private final SessionEngine engine;
    private final AtomicBoolean boatsLookedFor = new AtomicBoolean();
    private final AtomicBoolean begins = new AtomicBoolean();
    private final CompletableFuture<Void> begun = new CompletableFuture<>();
    private final AtomicBoolean closed = new AtomicBoolean();
    private final Fleet fleet;
    private final ByHand byHand;
    private final SessionProject project;
    private final JudgedAnswers drafts;
    private final Fence fence;
    private final MissionActions actions;
    private final EarlierBoats earlierBoats;

    private Session(SessionSetup setup) throws IOException {
        this.setup = setup;
        parts = new SessionParts(setup);
        engine = parts.engine;
        OperatorModels models = parts.models;
        fleet = new Fleet(
                parts.fleet.connector(),
                parts.fleet.listener(),
                engine.replies(),
                parts.fleet.settings(),
                parts.fleet.history(),
                parts.fleet.remembered(),
                models.fleetStop(),
                models.log(),
                models.missions()::title,
                parts.lostLinkWish,
                this::noteBegin);
        byHand = new ByHand(
                fleet,
                engine,
                setup.services(),
                models.log(),
                parts.messages,
                parts.threads::nowMs,
                parts.threads.drawing());
        project = new SessionProject(engine, new ProjectFiles(setup.vocabulary()), parts.threads.files());
        drafts = new JudgedAnswers(fleet, engine, setup.services(), parts.threads.drawing(), parts.robots);
        fence = new Fence(this::post, models.log());
        actions = new MissionActions(engine, models);
        earlierBoats = new EarlierBoats(setup.journal(), fleet, parts.messages);
    }

    /**
     * Opens a session. Nothing happens in it before {@link #begin}.
     *
     * @throws IOException if its journal cannot be read
     */
    public static Session open(SessionSetup setup) throws IOException {
        return new Session(setup);
    }

    /** Before the first link is made it is noted that this process has come: what was lost then is no loss of this one. */
    private void noteBegin() {
        if (boatsLookedFor.compareAndSet(false, true)) {
            parts.telemetry.begun();
            parts.fleet.history().processBegan();
        }
    }

    /**
     * Begins: delivers again what was open when an earlier process ended, and takes inputs in.
     *
     * @throws IllegalStateException if it has begun
     */
    public void begin() {
        if (!begins.compareAndSet(false, true)) {
            throw new IllegalStateException("the session has begun already");
        }
        noteBegin();
        parts.begin();
        begun.complete(null);
    }

    /** Completes when it has begun: what the engine is asked afterwards finds the models with what an earlier process left open. */
    public CompletionStage<Void> begun() {
        return begun;
    }

    /** The boats of earlier processes; for the time before {@link #begin}. */
    public EarlierBoats earlierBoats() {
        return earlierBoats;
    }

    /**
     * Lets a listener, and after it the models and the operators, hear what happened in earlier processes; before {@link #begin}, on the calling thread.
     *
     * @throws IOException if the journal cannot be read
     */
    public void replay(HostListener listener) throws IOException {
        parts.replay(listener);
    }

    // ---- missions

    /**
     * Starts a mission.
     *
     * @param plan its id
     * @param name of the mission, for people
     * @param parameters start values by {@code eventId.field} or {@code field}, and variables by {@code @name}; the plan asks for missing ones
     * @return the mission's id
     */
    @Override
    public CompletionStage<Long> start(String plan, String name, Map<String, Value> parameters) {
        return engine.posted().post(new Input.StartMission(plan, name, parameters), EngineAnswers::startedMission);
    }

    /** Aborts a mission: its boats stop doing what it asked. */
    @Override
    public CompletionStage<Void> abort(long mission) {
        return post(new Input.AbortMission(mission));
    }

    /** Aborts all missions. */
    @Override
    public CompletionStage<Void> abortAll() {
        return post(new Input.AbortMission(Ids.NONE));
    }

    /** Completes a mission. */
    @Override
    public CompletionStage<Void> complete(long mission) {
        return post(new Input.CompleteMission(mission));
    }

    /**
     * Presses an interrupt.
     *
     * @param mission that offers it, or {@link Ids#NONE} for every mission that does
     * @param boats whom it is about; empty for a general one, or where they are to be chosen
     */
    @Override
    public CompletionStage<Void> press(String interrupt, long mission, List<String> boats) {
        return post(new Input.Interrupt(mission, interrupt, boats));
    }

    /**
     * Answers a decision. The first answer counts; a later one is refused.
     *
     * @param by name of the operator, for the other operators to see
     */
    @Override
    public CompletionStage<Void> answer(long decision, Answer answer, String by) {
        Input.AnswerDecision input = new Input.AnswerDecision(decision, answer, Answerer.OPERATOR);
        return engine.posted()
                .post(
                        input,
                        effects -> engine.operators().answeredBy(by),
                        effects -> EngineAnswers.answered(decision, effects));
    }

    @Override
    public CompletionStage<List<String>> answerJudged(Decision decision, Answer answer, String by) {
        return drafts.judge(decision, DraftAnswer.of(answer, decision.question()))
                .thenCompose(judged -> {
                    judged.refusal().ifPresent(why -> {
                        throw new RefusedException(why);
                    });
                    return answer(decision.id(), answer, by).thenApply(done -> judged.doubts());
                });
    }

    /** Stops the timer of a decision: autonomy does not answer it any longer. Refused where no timer runs. */
    @Override
    public CompletionStage<Void> hold(long decision) {
        return post(new Input.HoldDecision(decision));
    }

    /**
     * Asks once more of boats and services what failed for a mission that cannot go on ({@link org.sami.crw.operator.mission.StuckMission}). Refused where
     * nothing has failed that can be asked again.
     */
    @Override
    public CompletionStage<Void> sendAgain(long mission) {
        return actions.sendAgain(mission);
    }

    /** Writes a variable as a mission would; {@link Ids#NONE} writes a global one. */
    @Override
    public CompletionStage<Void> setVariable(long mission, String variable, Value value) {
        return post(new Input.SetVariable(mission, variable, value));
    }

    /** Takes a boat out of one mission, which waits for it no longer; the boat goes on with what others want of it. */
    @Override
    public CompletionStage<Void> drop(String boat, long mission) {
        return post(new Input.ProxyDropped(boat, mission));
    }

    /** Takes a boat out of all missions and disconnects it. When it is connected again, it joins as a new one. */
    @Override
    public CompletionStage<Void> drop(String boat) {
        return drop(boat, Ids.NONE)
                .thenCompose(dropped -> fleet.disconnect(boat))
                .thenAccept(known -> {});
    }

    // ---- what operators do apart from missions

    /**
     * Gives a task to another boat, or to nobody. Refused where the task is not of a running mission or is complete, or where the boat
     * takes no part in the mission.
     */
    @Override
    public CompletionStage<Void> moveTask(TaskId task, Optional<String> boat) {
        return actions.moveTask(task, boat);
    }

    /** The area in which boats are to stay. */
    public Fence fence() {
        return fence;
    }

    /** Writes something down in the operator's log, maybe about a place. */
    public void note(String text, Optional<GeoPoint> position) {
        parts.models.log().note(text, position);
    }

    @Override
    public CompletionStage<Void> addNote(String text, Optional<GeoPoint> position) {
        note(text, position);
        return CompletableFuture.completedFuture(null);
    }

    /** The session itself behind a front, where it runs in this process: for what only its own machine has, such as files, keys, what becomes of faults. */
    public static Optional<Session> inProcess(FrontSession front) {
        return front instanceof Session here ? Optional.of(here) : Optional.empty();
    }

    @Override
    public Vocabulary vocabulary() {
        return setup.vocabulary();
    }

    @Override
    public Project firstProject() {
        return setup.project();
    }

    @Override
    public long nowMillis() {
        return parts.threads.nowMs();
    }

    @Override
    public CompletionStage<Void> caughtUp() {
        return ask(view -> true).thenCompose(asked -> fleet.ask(boats -> null));
    }

    private CompletionStage<Void> post(Input input) {
        return engine.posted().post(input, effects -> null);
    }

    /** The plans that missions start from, and what global variables hold at first. */
    public SessionProject project() {
        return project;
    }

    // ---- boats, operators, listeners, models

    /** The boats. */
    @Override
    public Fleet fleet() {
        return fleet;
    }

    /** What an operator wants of boats without a plan. */
    @Override
    public ByHand byHand() {
        return byHand;
    }

    /** What lies before the operator; belongs to the front's executor. */
    @Override
    public OperatorModels models() {
        return parts.models;
    }

    /** Adds an operator, who is asked what waits and what will. For the engine's thread, or before {@link #begin}. */
    public Registration addOperator(SessionOperator operator) {
        return engine.operators().add(operator);
    }

    /** Adds a listener to the engine's steps; called on the engine's thread, must be quick. */
    @Override
    public Registration addListener(HostListener listener) {
        return engine.host().addListener(listener);
    }

    /**
     * Subscribes to all that happens to boats, links, commands and tasks, through a serial executor, such as a window's event thread.
     * The fleet never waits for the subscriber.
     */
    public Registration subscribe(Executor executor, Consumer<? super FleetEvent> subscriber) {
        return parts.fleet.events().subscribe(executor, subscriber);
    }

    /** Adds a listener to what the session notes. */
    public Registration addListener(SessionListener listener) {
        return parts.messages.add(listener);
    }

    /** Asks the engine's state. */
    @Override
    public <T> CompletionStage<T> ask(Function<EngineView, T> question) {
        return engine.ask(question);
    }

    /**
     * Finds the way on which a boat would go along a path for a mission now: from where it is, with the turns around what the mission's plan and the
     * project avoid. Empty for a boat of which it is not known where it is.
     */
    @Override
    public CompletionStage<Optional<List<GeoPoint>>> way(long mission, String boat, GeoPath path) {
        CompletionStage<Optional<BoatStart>> start =
                fleet().ask(boats -> boats.find(boat).flatMap(proxy -> HandWay.startOf(proxy, setup.services())));
        CompletionStage<WayLimits> limits = ask(view -> WayLimits.of(mission, view));
        return start.thenCombineAsync(
                        limits, (from, water) -> from.map(one -> one.way(path, water)), parts.threads.drawing())
                .thenApplyAsync(found -> found, parts.threads.front());
    }

    /** Judges drafts of answers and values before they are set, as things stand now. */
    @Override
    public JudgedAnswers drafts() {
        return drafts;
    }

    /**
     * The paths of the boats that wait for the answer to a decision about their ways; empty where it is about something else, or is answered.
     */
    @Override
    public CompletionStage<Optional<DoubtedPaths>> doubtedPaths(Decision decision) {
        return ask(view -> view.subject(decision.id()))
                .thenCompose(about -> fleet().ask(boats ->
                        about.flatMap(one -> parts.domain.handlers().doubtedPaths(decision.type(), one))));
    }

    /** Whether a service computes for a mission now, so that commands or answers are to come. */
    public boolean isComputing() {
        return parts.domain.handlers().isComputing();
    }

    /**
     * Says on the engine's thread, a little later, of which boats missions want something, now or when nothing keeps them any longer. What
     * was asked of boats before has reached their proxies by then.
     */
    public void boatsWithWork(Consumer<Set<String>> then) {
        parts.fleet.boatsWithWork(then);
    }

    /** The caller writes down where boats were; else the session does. */
    public void leavePosesToCaller() {
        parts.fleet.watches().leavePosesToCaller();
    }

    /** What the session notes next to the engine's inputs. */
    public SessionTelemetry telemetry() {
        return parts.telemetry;
    }

    /** What the session was opened with. */
    public SessionSetup setup() {
        return setup;
    }

    /**
     * The engine's host: for programs that post inputs of their own, and that ask at once. {@link EngineHost#ask} is not for a window's
     * event thread.
     */
    public EngineHost host() {
        return engine.host();
    }

    /** The session's time; its actions run on the engine's thread. */
    public Scheduler scheduler() {
        return parts.threads.scheduler();
    }

    /** What becomes of it when its engine, its journal or a thread fails. */
    public SessionFaults faults() {
        return parts.faults;
    }

    /** Has something done on the engine's thread. */
    public void execute(Runnable work) {
        parts.threads.engine().execute(work);
    }

    // ---- the end

    /**
     * The engine takes up no further work: what it does now is the last. From any thread, also the engine's. The stage completes on the
     * engine's thread, when that is done.
     */
    public CompletionStage<Void> halt() {
        return parts.threads.halt();
    }

    /** Completes when every picture that could come from boats has come. From any thread; the stage completes on the fleet's. */
    public CompletionStage<Void> picturesFetched() {
        return parts.fleet.pictures().map(FleetPictures::done).orElseGet(() -> CompletableFuture.completedFuture(null));
    }

    /** Leaves the boats stopped ({@link #leave(BoatsAtEnd)}). */
    public List<String> leave() {
        return leave(BoatsAtEnd.STOP);
    }

    /**
     * Sends the boats their last commands and waits until they execute them, 3 s at most; none where another base took the session over, whose boats they are. Boats that are driven by hand are given back
     * before, and can be driven no longer, unless they are to go on. Afterwards this session commands no boat and records nothing about boats. Blocks: not for a thread of the session's own, nor a window's event thread.
     *
     * @return the boats that have not confirmed it, in words
     */
    public List<String> leave(BoatsAtEnd end) {
        return leave(end, () -> {});
    }

    /** The same; something is waited for when the boats have been commanded, while what they report still counts. */
    public List<String> leave(BoatsAtEnd end, Runnable last) {
        parts.domain.handlers().close();
        BoatsAtEnd then = setup().journal().isTakenOver() ? BoatsAtEnd.GO_ON : end;
        if (then != BoatsAtEnd.GO_ON) {
            fleet.endDriving();
        }
        return new EndCommands(then).giveTo(parts.fleet, last);
    }

    /**
     * Ends the session: links, threads, host and journal are closed, results that are open fail. Boats go on with what they were commanded
     * until they notice that the link is lost. Blocks for a few seconds at most; not for a thread of the session's own.
     */
    @Override
    public void close() throws IOException {
        if (closed.compareAndSet(false, true)) {
            parts.close();
        }
    }
}
