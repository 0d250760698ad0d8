package org.sami.crw.proxy.execution;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.Progress;
import org.sami.boat.link.StopMotors;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.execution.CommandRun.Verdict;
import org.sami.crw.proxy.explanation.LastCommandOutcome;
import org.sami.crw.proxy.link.PendingRequests;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.queue.CommandQueue;
import org.sami.crw.proxy.queue.QueuedCommand;
import org.sami.spn.value.GeoPoint;

/**
 * Keeps the boat at the command whose turn it is: begins a try, draws the consequences of the boat's answers, tries again,
 * stops the boat when nothing is left. Whether the boat may be commanded at all is the proxy's to know.
 */
public final class CommandDriver {

    private final String boatId;
    private final ProxyConfig config;
    private final DeferredEvents announcements;
    private final PendingRequests requests; // of the running command, or to stop for want of one
    private final CommandQueue queue = new CommandQueue();
    private final PlaceHold hold = new PlaceHold();
    private final Uploads uploads;
    private final UnwantedDrive unwanted;
    private final Supplier<Optional<GeoPoint>> position;
    private final DoubleSupplier cruiseMps;
    private final BooleanSupplier flies;
    private final ExpectedWayHome wayHome;
    private Optional<CommandRun> run = Optional.empty();
    private Optional<Underway> earlier = Optional.empty(); // what the boat drove along until its command was taken
    private Optional<NearbyEdges> noGoEdges = Optional.empty();
    private LastCommandOutcome lastWord = LastCommandOutcome.NONE;
    private int wireIds;
    private boolean mustStop;
    private boolean isHeldForPosition;
    private Progress held = new Progress("", 0, false);
    private String earlierList = "";

    /**
     * A driver.
     *
     * @param position gives where the boat is, if that is known
     * @param cruiseMps gives its speed on paths that name none, in m/s
     * @param flies gives whether it takes altitudes
     * @param wayHome learns what the boat knows of its ways home
     */
    public CommandDriver(
            String boatId,
            ProxyConfig config,
            ProxyLink link,
            DeferredEvents announcements,
            Supplier<Optional<GeoPoint>> position,
            DoubleSupplier cruiseMps,
            BooleanSupplier flies,
            ExpectedWayHome wayHome) {
        this.position = position;
        this.cruiseMps = cruiseMps;
        this.flies = flies;
        this.wayHome = wayHome;
        this.boatId = boatId;
        this.config = config;
        this.announcements = announcements;
        requests = new PendingRequests(link, config);
        uploads = new Uploads(boatId, announcements);
        unwanted = new UnwantedDrive(config);
    }

    /** The commands that missions have for the boat. */
    public CommandQueue queue() {
        return queue;
    }

    /** The try that is under way. */
    public Optional<CommandRun> run() {
        return run;
    }

    /** The edges of what the boat is not to enter, by the command that moved it last. */
    public Optional<NearbyEdges> noGoEdges() {
        return noGoEdges;
    }

    /** Whether the boat was sent somewhere, and has not said that it is there. */
    public boolean isDriving() {
        return run.isPresent() && run.get().isDriving();
    }

    /** Whether a stop for lack of commands is still unanswered, or still has to be sent. */
    public boolean isStopping() {
        return run.isEmpty() && (mustStop || requests.areWaiting());
    }

    /** The paths that went to the boat. */
    public Uploads uploads() {
        return uploads;
    }

    /** What the boat said last that it holds, and how far it is. */
    public void holds(Progress progress) {
        held = progress;
    }

    /** Names the list that an earlier process of this base sent to the boat last. */
    public void earlierList(String listId) {
        earlierList = listId;
    }

    /** What became of the command that left the queue last. */
    public LastCommandOutcome lastWord() {
        return lastWord;
    }

    /** How often the oldest unanswered request has been sent. */
    public int sends() {
        return requests.sends();
    }

    /** Takes a command; its turn comes when {@link #settle} is called. */
    public void submit(BoatCommand command) {
        queue.submit(command)
                .forEach(
                        (displaced, why) -> announcements.add(new FleetEvent.CommandWithdrawn(boatId, displaced, why)));
    }

    /** Whether the boat holds its place, since its path was given up and nobody wants anything of it. */
    public boolean isHolding() {
        return run.isPresent() && hold.is(run.get().queued());
    }

    /** The boat is out of this base's hands: the base no longer asks it to hold its place or to stop. */
    public void endHold() {
        if (isHolding()) {
            abandon("the boat holds its place no longer");
        }
        hold.end();
    }

    /** Takes back all that a mission has for the boat, and its block. Gives what it was. */
    public List<BoatCommand> withdraw(long mission) {
        hold.end(mission);
        List<BoatCommand> withdrawn = queue.withdraw(mission);
        withdrawn.forEach(command -> lastWord = LastCommandOutcome.withdrawn(command));
        return withdrawn;
    }

    /** Takes back one command; empty if the boat has none of that id. */
    public Optional<BoatCommand> withdraw(String commandId) {
        return queue.withdraw(commandId);
    }

    /** One command fails, for a reason in words. Returns whether it was queued. */
    public boolean fail(String commandId, String reason) {
        Optional<BoatCommand> gone = queue.withdraw(commandId);
        gone.ifPresent(command -> {
            lastWord = LastCommandOutcome.failed(command, reason);
            announcements.add(new FleetEvent.CommandFailed(boatId, command, reason));
        });
        return gone.isPresent();
    }

    /** Every command fails, for a reason in words. */
    public void failAll(String reason) {
        hold.end();
        for (BoatCommand command : queue.clear()) {
            lastWord = LastCommandOutcome.failed(command, reason);
            announcements.add(new FleetEvent.CommandFailed(boatId, command, reason));
        }
    }

    /** Forgets the try that is under way, because the boat has been taken out of its hands; a new one follows. */
    public void abandon(String why) {
        run = Optional.empty();
        requests.clear();
        uploads.givenUp(why);
    }

    /**
     * Forgets the try that is under way, whose list the boat may be driving along: it is stopped as soon as it can be commanded, unless a new try takes
     * its place.
     */
    public void abandonMoving(String why) {
        mustStop |= run.isPresent() || requests.areWaiting();
        abandon(why);
    }

    /** The boat is latched: it lies still, and stays so after the release. */
    public void latched() {
        mustStop = false;
    }

    /** The boat says whether it drives along its list; one that does so for no command is stopped. */
    public void drives(boolean alongList, long nowMs) {
        if (!isHeldForPosition) { // else the command for it is still to be checked
            mustStop |= unwanted.isToStop(alongList, run.isPresent() || task().isPresent(), nowMs);
        }
    }

    /**
     * The boat is somewhere on its way; gives the path up if it does not come along it.
     *
     * @param canMove whether there is no other reason for it to lie still
     */
    public void at(GeoPoint position, boolean canMove, long nowMs) {
        Optional<ProgressMonitor> headway = run.flatMap(CommandRun::headway);
        if (headway.isPresent()) {
            Optional<GeoPoint> target = run.get().target();
            if (!canMove || target.isEmpty()) {
                headway.get().pause(nowMs);
            } else {
                headway.get().at(position, run.get().targetIndex(), target.get(), nowMs);
            }
            if (headway.get().isHopeless()) {
                giveUp(run.get(), headway.get().words(), position);
            }
        }
    }

    /** The boat cannot follow its path; where no command takes its turn it holds its place. */
    private void giveUp(CommandRun failed, String why, GeoPoint at) {
        QueuedCommand queued = failed.queued();
        boolean wasMissions = !hold.is(queued);
        conclude(failed.because(Verdict.FAILED, why));
        if (wasMissions) {
            hold.begin(queued.command(), at);
            announcements.add(new FleetEvent.PlaceHeld(boatId, queued.command()));
        }
    }

    /** The boat lies, or drifts, at a position. */
    public void lies(GeoPoint position, long nowMs) {
        run.ifPresent(one -> conclude(one.at(position, nowMs)));
    }

    /** Wants the boat stopped unless a command is waiting for it. */
    public void stopWhenIdle() {
        mustStop = true;
    }

    /** An id on the link that was never used before: of the command, this base, its start, and a count. */
    public String wireId(String of) {
        return of + "#" + config.clientId() + "." + config.epoch() + "." + ++wireIds;
    }

    /**
     * Brings the boat to the command whose turn it is.
     *
     * @param mayCommand whether the boat takes commands now; if not, only what needs no boat is done
     */
    public void settle(boolean mayCommand, long nowMs) {
        completeEmptyPaths();
        if (!mayCommand) {
            return;
        }
        if (run.isPresent() && !isRunCurrent()) {
            earlier = run.get().underway(nowMs);
            abandon("its command is no longer wanted");
            mustStop = true;
            completeEmptyPaths(); // the one that took the boat may have nothing to do
        }
        Optional<QueuedCommand> task = task();
        if (run.isEmpty() && task.isPresent() && !lacksPosition(task.get())) {
            mustStop = false;
            begin(task.get(), nowMs);
        } else if (run.isEmpty() && mustStop) {
            mustStop = false;
            requests.clear();
            requests.send(new StopMotors(wireId("idle") + "/stop"), nowMs);
        }
    }

    /** A path of which nothing is left needs no boat. */
    private void completeEmptyPaths() {
        for (var current = queue.current();
                current.isPresent()
                        && run.isEmpty()
                        && current.get().command() instanceof FollowPath path
                        && current.get().visited() >= path.points().size();
                current = queue.current()) {
            finish(current.get());
        }
    }

    /**
     * Whether nothing is begun because the boat has not said where it is: its way is checked from there, and planned around what it is not to enter.
     */
    public boolean waitsForPosition() {
        return run.isEmpty()
                && (isHeldForPosition || task().filter(this::lacksPosition).isPresent());
    }

    /** A command is kept back until the boat says where it is, or no longer is. */
    public void awaitPosition(boolean waits) {
        isHeldForPosition = waits;
    }

    private boolean lacksPosition(QueuedCommand queued) {
        return queued.command().water().isPresent() && position.get().isEmpty();
    }

    /** The boat's present task: a mission's command, otherwise to hold its place. */
    private Optional<QueuedCommand> task() {
        return queue.current().isPresent() ? queue.current() : hold.station();
    }

    private void begin(QueuedCommand queued, long nowMs) {
        if (!hold.is(queued)) {
            hold.end(); // somebody has decided
        }
        requests.clear();
        String wireId = wireId(queued.command().commandId());
        CommandRun next = run(queued, wireId);
        run = Optional.of(next);
        next.begin(nowMs);
        earlier = Optional.empty();
    }

    private CommandRun run(QueuedCommand queued, String wireId) {
        double speedMps = cruiseMps.getAsDouble();
        if (queued.command() instanceof FollowPath path) {
            noGoEdges = path.water().map(NearbyEdges::new);
            return new PathRun(
                    queued,
                    path,
                    position,
                    flies,
                    wayHome,
                    earlier,
                    wireId,
                    adoptable(queued),
                    speedMps,
                    requests,
                    uploads::reached);
        } else if (queued.command() instanceof KeepStation station) {
            noGoEdges = station.water().map(NearbyEdges::new);
            return new StationRun(
                    queued, station, position, flies, wayHome, earlier, wireId, speedMps, requests, uploads::reached);
        }
        return queued.command() instanceof Panorama panorama
                ? new PanoramaRun(queued, panorama, wireId, requests)
                : new StopRun(queued, wireId, requests);
    }

    /** The list that the boat holds, if it may be the command's path from an earlier process; asked about once. */
    private Optional<PathRun.Adopted> adoptable(QueuedCommand queued) {
        String listId = earlierList;
        earlierList = "";
        boolean may = !listId.isEmpty()
                && listId.equals(held.listId())
                && listId.startsWith(queued.command().commandId() + "#");
        return may
                ? Optional.of(new PathRun.Adopted(listId, () -> held, count -> visited(queued, count)))
                : Optional.empty();
    }

    private boolean isRunCurrent() {
        Optional<QueuedCommand> task = task();
        return run.isPresent() && task.isPresent() && task.get() == run.get().queued();
    }

    /** Sends again what is due; gives up a command that stays unanswered, but never a stop. */
    public void tick(long nowMs) {
        if (!requests.areWaiting()) {
            return;
        }
        for (CommandMessage unanswered : requests.tick(nowMs)) {
            if (run.isPresent()) {
                String why = "the boat did not answer " + config.maxSends() + " requests";
                conclude(run.get().because(Verdict.FAILED, why));
            } else {
                requests.send(unanswered, nowMs);
            }
        }
    }

    /** The boat has answered a command message of this driver. */
    public void answered(String commandId, LinkMessage answer, long nowMs) {
        Optional<CommandMessage> asked = requests.answered(commandId);
        if (asked.isPresent() && run.isPresent()) {
            conclude(run.get().answered(asked.get(), answer, nowMs));
        }
    }

    /** The boat has refused something. Returns whether it did so for a reason that will pass. */
    public boolean refused(Nack nack) {
        Optional<CommandMessage> asked = requests.answered(nack.commandId());
        if (asked.isEmpty() || run.isEmpty()) {
            return false;
        }
        Verdict verdict = run.get().refused(nack);
        conclude(verdict);
        return verdict == Verdict.WAIT;
    }

    /** The boat has said how far it is. */
    public void progressed(Progress progress) {
        if (noteVisited(progress) && progress.completed()) {
            conclude(run.orElseThrow().arrived());
        }
    }

    /** The boat has taken pictures. */
    public void taken(PanoramaReport report) {
        if (run.isPresent() && run.get() instanceof PanoramaRun panorama && panorama.isAbout(report)) {
            BoatCommand command = panorama.queued().command();
            GeoPoint from = GeoPoint.of(report.latDeg(), report.lonDeg());
            announcements.add(new FleetEvent.PanoramaTaken(boatId, command, report.pictures(), from, report.files()));
            conclude(Verdict.COMPLETED);
        }
    }

    /** The boat has said how far it is, after a time without a link. */
    public void resume(Progress held, long nowMs) {
        noteVisited(held);
        if (isRunCurrent()) {
            requests.clear();
            conclude(run.get().resume(held, nowMs));
        } else if (isStopping()) {
            requests.clear();
            mustStop = true; // under a new id: it may have stopped before, and moved again for its lost link
        }
        unwanted.resumed(held);
    }

    /** Returns whether the report was about the command under way. */
    private boolean noteVisited(Progress progress) {
        boolean told = run.isPresent() && run.get().isAbout(progress);
        int visited = told ? run.get().visited(progress) : 0;
        if (told && run.get().queued().command() instanceof FollowPath) { // a station is come to again and again
            visited(run.get().queued(), visited);
        }
        return told;
    }

    private void visited(QueuedCommand queued, int count) {
        if (queued.visitedUpTo(count)) {
            announcements.add(new FleetEvent.Progressed(boatId, queued.command(), count));
        }
    }

    /** Draws the consequence of a verdict on the running command. */
    private void conclude(Verdict verdict) {
        if (verdict == Verdict.GO_ON) {
            return;
        }
        CommandRun ended = run.orElseThrow();
        QueuedCommand queued = ended.queued();
        abandon(ended.why());
        if (verdict == Verdict.COMPLETED) {
            finish(queued);
        } else if (hold.is(queued)) {
            if (verdict == Verdict.FAILED
                    || (verdict == Verdict.RETRY && queued.failedTry() >= CommandDefaults.MAX_TRIES)) {
                mustStop = true;
                hold.end();
            }
        } else if (verdict == Verdict.FAILED
                || (verdict == Verdict.RETRY && queued.failedTry() >= CommandDefaults.MAX_TRIES)) {
            mustStop = true;
            queue.finish(queued);
            lastWord = LastCommandOutcome.failed(queued.command(), ended.why());
            announcements.add(new FleetEvent.CommandFailed(boatId, queued.command(), ended.why()));
        }
    }

    private void finish(QueuedCommand queued) {
        if (queued.command() instanceof FollowPath path) {
            visited(queued, path.points().size());
        }
        queue.finish(queued);
        lastWord = LastCommandOutcome.arrived(queued.command());
        announcements.add(new FleetEvent.CommandCompleted(boatId, queued.command()));
    }
}
