package org.sami.crw.operator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.operator.boat.BoatCommands.Concluded;
import org.sami.crw.operator.boat.BoatCommands.End;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.spn.value.GeoPoint;

/** The command queues of all boats. Follows the fleet's events. */
public final class CommandModel extends Model<List<BoatCommands>> {
    private static final int CONCLUDED_KEPT = 20;

    private final Map<String, Tracked> boats = new LinkedHashMap<>();

    private static final class Tracked {
        private final Deque<Concluded> concluded = new ArrayDeque<>();
        private CommandQueueSnapshot queue = CommandQueueSnapshot.EMPTY;
        private Optional<Upload> upload = Optional.empty();
        private boolean byHand;
        private boolean elsewhere;
    }

    CommandModel() {
        super(List.of());
    }

    /** Whether an event changes something here. */
    static boolean concerns(FleetEvent event) {
        return event instanceof FleetEvent.QueueChanged
                || event instanceof FleetEvent.Progressed
                || event instanceof FleetEvent.CommandCompleted
                || event instanceof FleetEvent.CommandFailed
                || event instanceof FleetEvent.CommandWithdrawn
                || event instanceof FleetEvent.UploadAdvanced
                || event instanceof FleetEvent.TakenOver
                || event instanceof FleetEvent.HandedBack
                || event instanceof FleetEvent.CommanderChanged
                || event instanceof FleetEvent.Found
                || event instanceof FleetEvent.Removed;
    }

    /** Forgets all. */
    void clear() {
        boats.clear();
        change();
    }

    void apply(FleetEvent event, long atMillis) {
        if (event instanceof FleetEvent.Removed) {
            boats.remove(event.boat());
            change();
            return;
        }
        Tracked boat = boats.computeIfAbsent(event.boat(), id -> new Tracked());
        if (event instanceof FleetEvent.QueueChanged e) {
            changed(boat, e.queue(), atMillis);
        } else if (event instanceof FleetEvent.Progressed e) {
            boat.queue = progressed(boat.queue, e.command().commandId(), e.visited());
        } else if (event instanceof FleetEvent.CommandCompleted e) {
            concluded(boat, e.command(), End.COMPLETED, "", atMillis);
        } else if (event instanceof FleetEvent.CommandFailed e) {
            concluded(boat, e.command(), End.FAILED, e.reason(), atMillis);
        } else if (event instanceof FleetEvent.CommandWithdrawn e) {
            concluded(boat, e.command(), End.DISPLACED, e.why().name().toLowerCase(Locale.ROOT), atMillis);
        } else if (event instanceof FleetEvent.UploadAdvanced e) {
            boat.upload = Optional.of(e.upload());
        } else if (event instanceof FleetEvent.TakenOver) {
            boat.byHand = true;
        } else if (event instanceof FleetEvent.HandedBack) {
            boat.byHand = false;
        } else if (event instanceof FleetEvent.CommanderChanged e) {
            boat.elsewhere = !e.commands();
        }
        change();
    }

    /** What has left the queue without a word was taken back by its mission. */
    private static void changed(Tracked boat, CommandQueueSnapshot now, long atMillis) {
        List<String> queued = all(now).map(entry -> entry.command().commandId()).toList();
        all(boat.queue)
                .map(Entry::command)
                .filter(command -> !queued.contains(command.commandId()))
                .filter(command -> boat.concluded.stream()
                        .noneMatch(gone -> gone.command().commandId().equals(command.commandId())))
                .forEach(command -> concluded(boat, command, End.WITHDRAWN, "its mission took it back", atMillis));
        boat.queue = now;
    }

    private static Stream<Entry> all(CommandQueueSnapshot queue) {
        return Stream.concat(queue.current().stream(), queue.waiting().stream());
    }

    private static CommandQueueSnapshot progressed(CommandQueueSnapshot queue, String command, int visited) {
        return new CommandQueueSnapshot(
                queue.current()
                        .map(entry -> entry.command().commandId().equals(command) ? entry.withVisited(visited) : entry),
                queue.waiting(),
                queue.blockedBy());
    }

    private static void concluded(Tracked boat, BoatCommand command, End end, String why, long atMillis) {
        boat.concluded.add(new Concluded(command, end, why, atMillis));
        if (boat.concluded.size() > CONCLUDED_KEPT) {
            boat.concluded.poll();
        }
    }

    /** The queue of a boat, on the owner's thread. */
    CommandQueueSnapshot queue(String boat) {
        Tracked tracked = boats.get(boat);
        return tracked == null ? CommandQueueSnapshot.EMPTY : tracked.queue;
    }

    /** What a boat drives along for a command, as it was sent; empty where nothing was, or the command has no path. */
    Optional<List<GeoPoint>> way(String boat, String commandId) {
        return Optional.ofNullable(boats.get(boat))
                .flatMap(tracked -> tracked.upload)
                .filter(upload -> upload.commandId().equals(commandId) && upload.state() != Upload.State.FAILED)
                .map(Upload::way);
    }

    @Override
    List<BoatCommands> take() {
        List<BoatCommands> all = new ArrayList<>();
        boats.forEach((id, boat) -> all.add(new BoatCommands(
                id,
                boat.queue,
                boat.upload,
                boat.byHand ? "a person drives it by hand" : boat.elsewhere ? "another client commands it" : "",
                List.copyOf(boat.concluded))));
        return all;
    }
}
