package org.sami.crw.fleet;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.LeftOut;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.task.TaskNews;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;

/** Something that happened to a boat, to its link, to its commands or to its tasks. Immutable. */
public sealed interface FleetEvent {
    /** Id of the boat; empty text where the event is about none, or the boat is not known. */
    String boat();

    /** An event that brings all that is known of a boat. */
    sealed interface OfStatus extends FleetEvent {
        /** The boat as it is known after the event. */
        BoatStatus status();

        @Override
        default String boat() {
            return status().boatId();
        }
    }

    // ---- links

    /** A boat with a new id answered, and its proxy takes commands. */
    record Found(String boat) implements FleetEvent {}

    /** The link to a boat came or went. */
    record LinkChanged(BoatStatus status) implements OfStatus {}

    /** A boat is reached at another address from now on. */
    record Moved(String boat, InetSocketAddress from, InetSocketAddress to) implements FleetEvent {}

    /** A boat's server restarted; nothing moves the boat until the operator allows it. */
    record Restarted(BoatStatus status) implements OfStatus {}

    /** A boat whose server had restarted may be moved again. */
    record RestartAllowed(BoatStatus status) implements OfStatus {}

    /** The base gave a boat up; its commands have failed. */
    record Retired(String boat) implements FleetEvent {}

    /** A boat is no longer among those of the base. */
    record Removed(String boat) implements FleetEvent {}

    /** The operator must know something about a link and act on it. */
    record LinkAlarmed(LinkAlarm alarm) implements FleetEvent {
        @Override
        public String boat() {
            return alarm.boatId();
        }
    }

    /** A boat sends more than the base takes, still does so, or no longer does: what was left out. */
    record TooMuchSent(String boat, LeftOut leftOut) implements FleetEvent {}

    // ---- telemetry

    /** Telemetry came. */
    record StatusReported(BoatStatus status) implements OfStatus {}

    /** The class of a boat's battery was reported: when the link came, and at each change of class. */
    record BatteryReported(String boat, BatteryState battery) implements FleetEvent {}

    /** One of a boat's sensors measured something. */
    record Measured(String boat, BoatReading reading) implements FleetEvent {}

    // ---- who commands

    /** A person at this base drives the boat by hand; its commands wait. */
    record TakenOver(String boat) implements FleetEvent {}

    /** The person gave the boat back; its commands go on. */
    record HandedBack(String boat) implements FleetEvent {}

    /**
     * This base commands the boat from now on, or does so no longer.
     *
     * @param controller who has taken it and is no base, as the boat names them: a pilot, another ground station or its own failsafe; empty for a base
     */
    record CommanderChanged(String boat, boolean commands, Optional<String> controller) implements FleetEvent {}

    /** Another client wishes to command the boat. */
    record CommandAsked(String boat, String client) implements FleetEvent {}

    /** The boat refuses this base, or a hand-over that it asked for, for a reason in words. */
    record Refused(String boat, String reason) implements FleetEvent {}

    /** The release of a boat that the operator ordered is not asked for any longer, for a reason in words; the boat may still be stopped. */
    record ReleaseDropped(String boat, String reason) implements FleetEvent {}

    // ---- commands

    /** Commands came into a boat's queue or left it, or another one has its turn. */
    record QueueChanged(String boat, CommandQueueSnapshot queue) implements FleetEvent {}

    /** More points of a path are behind the boat: how many, counted from the beginning of the path. */
    record Progressed(String boat, BoatCommand command, int visited) implements FleetEvent {}

    /** A command is done. */
    record CommandCompleted(String boat, BoatCommand command) implements FleetEvent {}

    /** A command cannot be done, for a reason in words; it has left the queue. */
    record CommandFailed(String boat, BoatCommand command, String reason) implements FleetEvent {}

    /** The boat holds its place since this command was given up, until it gets another one. */
    record PlaceHeld(String boat, BoatCommand givenUp) implements FleetEvent {}

    /** Another command displaced this one for good; it has left the queue. */
    record CommandWithdrawn(String boat, BoatCommand command, Withdrawal why) implements FleetEvent {}

    /** A path came further on its way to the boat, or failed to. */
    record UploadAdvanced(String boat, Upload upload) implements FleetEvent {}

    /**
     * The boat took the pictures of a panorama, and keeps them on board.
     *
     * @param files their names on board, in the order in which they were taken; empty if the boat names none
     */
    record PanoramaTaken(String boat, BoatCommand command, int pictures, GeoPoint from, List<String> files)
            implements FleetEvent {
        public PanoramaTaken {
            files = List.copyOf(files);
        }
    }

    /**
     * A picture has come whole from the boat.
     *
     * @param panorama id of the command that took it
     * @param name of the file on board
     * @param file where it is on this machine
     */
    record PictureFetched(String boat, String panorama, String name, Path file) implements FleetEvent {}

    /**
     * A picture will not come from the boat.
     *
     * @param panorama id of the command that took it
     * @param name of the file on board
     * @param reason in words, with the boat and the picture
     */
    record PictureMissed(String boat, String panorama, String name, String reason) implements FleetEvent {}

    /** The operator was warned: on its present way the boat may come into an area to avoid, by at most this many metres. */
    record DepthAnnounced(String boat, double insideM) implements FleetEvent {}

    // ---- settings

    /** The boat said which settings are in force on it. */
    record SettingsReported(String boat, BoatTuning settings) implements FleetEvent {}

    /** The boat took a setting, that of the command. */
    record SettingTaken(String boat, String commandId) implements FleetEvent {}

    /** The boat did not take a setting, for a reason in words. */
    record SettingRefused(String boat, String commandId, String reason) implements FleetEvent {}

    // ---- tasks

    /**
     * Something happened to a task.
     *
     * @param names the task by the names that running missions have for it
     */
    record TaskChanged(TaskNews news, List<TaskId> names) implements FleetEvent {
        public TaskChanged {
            Objects.requireNonNull(news, "news");
            names = List.copyOf(names);
        }

        @Override
        public String boat() {
            return news.boat();
        }
    }

    // ---- faults of this program

    /**
     * A listener of these events threw; all others received the event.
     *
     * @param listener name of its class
     */
    record ListenerFault(String listener, Throwable cause) implements FleetEvent {
        @Override
        public String boat() {
            return "";
        }
    }

    /**
     * Something in this program threw; all else goes on.
     *
     * @param where in words
     */
    record Fault(String where, Throwable cause) implements FleetEvent {
        @Override
        public String boat() {
            return "";
        }
    }
}
