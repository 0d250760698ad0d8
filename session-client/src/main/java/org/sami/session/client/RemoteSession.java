package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import java.util.function.Supplier;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.operator.OperatorModels;
import org.sami.session.api.DraftJudge;
import org.sami.session.api.FrontFleet;
import org.sami.session.api.FrontSession;
import org.sami.session.api.GuidedBoats;
import org.sami.session.api.RefusedException;
import org.sami.session.follow.FollowedSession;
import org.sami.spn.engine.EngineView;
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
 * A session that runs in another process and is served by {@code crw serve} (docs/session-link.md). Models and engine here follow it; commands are requests to its server,
 * which says what came of them after their results have arrived here. A lost connection is made again by itself, and what is shown meanwhile is as it was seen last.
 */
public final class RemoteSession implements FrontSession, AutoCloseable {
    private final Login login;
    private final LinkThreads threads = new LinkThreads();
    private final SessionFollower follower;
    private final RemoteRequests requests;
    private final RemoteFleet fleet;
    private final AtomicBoolean closed = new AtomicBoolean();

    private RemoteSession(
            List<SessionAddress> bases,
            Login login,
            ServerTrust trust,
            Executor front,
            RemoteListener listener,
            Supplier<LocalTime> wallClock) {
        this.login = login;
        requests = new RemoteRequests(this::send, front);
        fleet = new RemoteFleet(requests, this::models, () -> followed().lostLinkWish(), this::holder);
        follower = new SessionFollower(
                bases, login, trust, front, threads.map(), listener, wallClock, threads.link(), fleet::unclaimed);
    }

    /**
     * Connects, logs in and waits until the session is known here. A standby among the bases is asked again until one of them holds the session.
     *
     * @param bases where the session may be, at least one; bases that these name are found as well
     * @param front where models live and results arrive: a window's event thread, or a thread of the caller's
     * @param wallClock the time of day, for people
     * @throws IOException in words, if no server answers, it does not let this person in, or this program cannot follow the session
     */
    public static RemoteSession open(
            List<SessionAddress> bases,
            Login login,
            ServerTrust trust,
            Executor front,
            RemoteListener listener,
            Supplier<LocalTime> wallClock)
            throws IOException, InterruptedException {
        RemoteSession session = new RemoteSession(bases, login, trust, front, listener, wallClock);
        session.follower.start();
        try {
            session.follower.shown().get();
            return session;
        } catch (ExecutionException fault) {
            session.close();
            Throwable why = fault.getCause() == null ? fault : fault.getCause();
            throw new IOException(RefusedException.reason(why), fault);
        } catch (InterruptedException ended) {
            session.close();
            throw ended;
        }
    }

    /** Fetches the pictures of the session's boats from now on, as somebody wants to see them. */
    public void fetchPictures() {
        threads.link().execute(follower::wantPictures);
    }

    /** The base that serves it, or did last. */
    public SessionAddress address() {
        return follower.base();
    }

    /** Who takes part here. */
    public String person() {
        return login.name();
    }

    /** What that person may do, as its server said last. */
    public PersonRights rights() {
        return follower.rights();
    }

    private CompletionStage<JsonNode> send(ObjectNode message) {
        return follower.request(message);
    }

    private Optional<TicketedBase> holder() {
        return follower.holder();
    }

    private FollowedSession followed() {
        return follower.shown().join().followed();
    }

    // ---- what is seen and asked

    @Override
    public OperatorModels models() {
        return followed().models();
    }

    @Override
    public Vocabulary vocabulary() {
        return followed().vocabulary();
    }

    @Override
    public Project firstProject() {
        return followed().project();
    }

    @Override
    public long nowMillis() {
        return follower.shown().join().nowMillis();
    }

    @Override
    public <T> CompletionStage<T> ask(Function<EngineView, T> question) {
        return requests.onFront(CompletableFuture.supplyAsync(() -> followed().ask(question), threads.link()));
    }

    @Override
    public CompletionStage<Void> caughtUp() {
        return requests.ask(ServerRequests.message("ping")).thenCompose(done -> models().shown());
    }

    @Override
    public Registration addListener(HostListener to) {
        return followed().addListener(to);
    }

    @Override
    public CompletionStage<Optional<List<GeoPoint>>> way(long mission, String boat, GeoPath path) {
        return requests.onFront(CompletableFuture.supplyAsync(() -> followed().start(boat), threads.link())
                .thenCombineAsync(
                        CompletableFuture.supplyAsync(
                                () -> followed().ask(view -> WayLimits.of(mission, view)), threads.link()),
                        (start, limits) -> start.map(one -> one.way(path, limits)),
                        threads.map()));
    }

    /** Which boats wait is known to the session's handlers only. */
    @Override
    public CompletionStage<Optional<DoubtedPaths>> doubtedPaths(Decision decision) {
        return CompletableFuture.completedFuture(Optional.empty());
    }

    // ---- what is done

    @Override
    public CompletionStage<Long> start(String plan, String name, Map<String, Value> parameters) {
        return requests.input(new Input.StartMission(plan, name, parameters))
                .thenApply(done -> done.path("mission").asLong());
    }

    @Override
    public CompletionStage<Void> abort(long mission) {
        return requests.post(new Input.AbortMission(mission));
    }

    @Override
    public CompletionStage<Void> abortAll() {
        return requests.post(new Input.AbortMission(Ids.NONE));
    }

    @Override
    public CompletionStage<Void> complete(long mission) {
        return requests.post(new Input.CompleteMission(mission));
    }

    @Override
    public CompletionStage<Void> press(String interrupt, long mission, List<String> boats) {
        return requests.post(new Input.Interrupt(mission, interrupt, boats));
    }

    @Override
    public CompletionStage<List<String>> answerJudged(Decision decision, Answer answer, String by) {
        return requests.input(new Input.AnswerDecision(decision.id(), answer, Answerer.OPERATOR))
                .thenApply(done -> LinkRowReader.texts(done.path("warnings")));
    }

    @Override
    public CompletionStage<Void> answer(long decision, Answer answer, String by) {
        return requests.post(new Input.AnswerDecision(decision, answer, Answerer.OPERATOR));
    }

    @Override
    public DraftJudge drafts() {
        return new RemoteDrafts(requests::ask);
    }

    @Override
    public GuidedBoats byHand() {
        return new RemoteByHand(requests::ask, fleet);
    }

    @Override
    public CompletionStage<Void> hold(long decision) {
        return requests.post(new Input.HoldDecision(decision));
    }

    @Override
    public CompletionStage<Void> sendAgain(long mission) {
        return requests.tell(ServerRequests.message("again").put("mission", mission));
    }

    @Override
    public CompletionStage<Void> setVariable(long mission, String variable, Value value) {
        return requests.post(new Input.SetVariable(mission, variable, value));
    }

    @Override
    public CompletionStage<Void> drop(String boat, long mission) {
        return requests.post(new Input.ProxyDropped(boat, mission));
    }

    @Override
    public CompletionStage<Void> drop(String boat) {
        return drop(boat, Ids.NONE);
    }

    @Override
    public CompletionStage<Void> moveTask(TaskId task, Optional<String> boat) {
        return requests.post(new Input.AllocateTasks(Map.of(task, boat)));
    }

    @Override
    public CompletionStage<Void> addNote(String text, Optional<GeoPoint> position) {
        ObjectNode note = ServerRequests.message("note").put("text", text);
        position.ifPresent(at -> note.put("lat", at.latDeg()).put("lon", at.lonDeg()));
        return requests.tell(note);
    }

    @Override
    public FrontFleet fleet() {
        return fleet;
    }

    /** Leaves the session, which goes on. */
    @Override
    public void close() {
        if (closed.compareAndSet(false, true)) {
            threads.end(follower::close);
        }
    }
}
