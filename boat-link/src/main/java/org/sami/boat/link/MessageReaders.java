package org.sami.boat.link;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** Every kind of message that can be received, by its word in the body. */
final class MessageReaders {

    /** Makes a message of the members of a body. */
    interface Reader {
        LinkMessage read(Fields in) throws LinkException;
    }

    private static final Map<String, Reader> BY_TYPE = new LinkedHashMap<>();

    static {
        BY_TYPE.put(Hello.TYPE, Hello::read);
        BY_TYPE.put(Welcome.TYPE, Welcome::read);
        BY_TYPE.put(Goodbye.TYPE, Goodbye::read);
        BY_TYPE.put(Heartbeat.TYPE, Heartbeat::read);
        BY_TYPE.put(Ack.TYPE, Ack::read);
        BY_TYPE.put(Nack.TYPE, Nack::read);
        BY_TYPE.put(UploadWaypoints.TYPE, UploadWaypoints::read);
        BY_TYPE.put(ReadBack.TYPE, ReadBack::read);
        BY_TYPE.put(HeldWaypoints.TYPE, HeldWaypoints::read);
        BY_TYPE.put(StartWaypoints.TYPE, StartWaypoints::read);
        BY_TYPE.put(StopMotors.TYPE, StopMotors::read);
        BY_TYPE.put(HoldPosition.TYPE, HoldPosition::read);
        BY_TYPE.put(TakePanorama.TYPE, TakePanorama::read);
        BY_TYPE.put(PanoramaReport.TYPE, PanoramaReport::read);
        BY_TYPE.put(FleetStop.TYPE, FleetStop::read);
        BY_TYPE.put(FleetRelease.TYPE, FleetRelease::read);
        BY_TYPE.put(AskForCommand.TYPE, AskForCommand::read);
        BY_TYPE.put(GrantCommand.TYPE, GrantCommand::read);
        BY_TYPE.put(TakeCommand.TYPE, TakeCommand::read);
        BY_TYPE.put(CommandAsked.TYPE, CommandAsked::read);
        BY_TYPE.put(Teleoperate.TYPE, Teleoperate::read);
        BY_TYPE.put(SetGains.TYPE, SetGains::read);
        BY_TYPE.put(SetVelocityMultiplier.TYPE, SetVelocityMultiplier::read);
        BY_TYPE.put(SetLostLinkAction.TYPE, SetLostLinkAction::read);
        BY_TYPE.put(SetWaysHome.TYPE, SetWaysHome::read);
        BY_TYPE.put(Telemetry.TYPE, Telemetry::read);
        BY_TYPE.put(Motion.TYPE, Motion::read);
        BY_TYPE.put(Traffic.TYPE, Traffic::read);
        BY_TYPE.put(BatteryReport.TYPE, BatteryReport::read);
        BY_TYPE.put(Progress.TYPE, Progress::read);
        BY_TYPE.put(SettingsReport.TYPE, SettingsReport::read);
        BY_TYPE.put(SensorReport.TYPE, SensorReport::read);
        BY_TYPE.put(Pair.TYPE, Pair::read);
        BY_TYPE.put(Paired.TYPE, Paired::read);
        BY_TYPE.put(WithdrawKeys.TYPE, WithdrawKeys::read);
        BY_TYPE.put(ListFiles.TYPE, ListFiles::read);
        BY_TYPE.put(FileList.TYPE, FileList::read);
        BY_TYPE.put(GetPiece.TYPE, GetPiece::read);
        BY_TYPE.put(FilePiece.TYPE, FilePiece::read);
        BY_TYPE.put(FileRefusal.TYPE, FileRefusal::read);
    }

    private MessageReaders() {}

    static Set<String> types() {
        return BY_TYPE.keySet();
    }

    static LinkMessage read(String type, Fields in) throws LinkException {
        Reader reader = BY_TYPE.get(type);
        if (reader == null) {
            throw new LinkException(LinkException.Fault.UNKNOWN_TYPE, "/type", "no message type that is known here");
        }
        return reader.read(in);
    }
}
