package org.sami.boat.server.log;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.server.CommandLedger;
import org.sami.boat.server.RememberedCommand;

/**
 * What a restarted boat needs of all entries so far: the commands that it remembers, and those in force. A new file of the log begins with it. The number of
 * the commander and the keys of bases have files of their own.
 */
final class CarriedState implements LogEntries {
    private final CommandLedger ledger = new CommandLedger();
    private final Map<GainAxis, Sent> gains = new EnumMap<>(GainAxis.class);
    private Optional<Sent> multiplier = Optional.empty();
    private Optional<Sent> lostLinkAction = Optional.empty();
    private Optional<Sent> list = Optional.empty();
    private Optional<Sent> waysHome = Optional.empty();
    private Optional<Sent> listOfWaysHome = Optional.empty();
    private Optional<Sent> latchedStop = Optional.empty();

    /** A command and who has sent it. */
    private static final class Sent {
        private final String clientId;
        private final CommandMessage command;

        Sent(String clientId, CommandMessage command) {
            this.clientId = clientId;
            this.command = command;
        }
    }

    @Override
    public void answered(LoggedCommand entry) {
        ledger.record(RememberedCommand.of(entry.clientId(), entry.command(), entry.answer()));
        if (entry.answer() instanceof Ack) {
            inForce(entry.clientId(), entry.command());
        }
    }

    @Override
    public void remembered(RememberedCommand command) {
        ledger.record(command);
    }

    @Override
    public void inForce(String clientId, CommandMessage command) {
        Optional<Sent> sent = Optional.of(new Sent(clientId, command));
        if (command instanceof UploadWaypoints) {
            list = sent;
        } else if (command
                instanceof SetWaysHome) { // they are in force until another list starts, over other uploads too
            waysHome = sent;
            listOfWaysHome = list;
        } else if (command instanceof SetGains) {
            gains.put(((SetGains) command).axis(), sent.get());
        } else if (command instanceof SetVelocityMultiplier) {
            multiplier = sent;
        } else if (command instanceof SetLostLinkAction) {
            lostLinkAction = sent;
        } else if (command instanceof FleetStop && !latchedStop.isPresent()) {
            latchedStop = sent;
        } else if (command instanceof FleetRelease) {
            latchedStop = Optional.empty();
        }
    }

    /** How many commands are remembered. */
    int size() {
        return ledger.entries().size();
    }

    /** The lines with which a new file begins, without ends. They can be made on any thread: nothing in them changes. */
    LogHead head(String bootId) {
        List<Sent> inForce = new ArrayList<>(gains.values());
        multiplier.ifPresent(inForce::add);
        lostLinkAction.ifPresent(inForce::add);
        listOfWaysHome.ifPresent(inForce::add);
        waysHome.ifPresent(inForce::add);
        boolean same = list.isPresent() && listOfWaysHome.isPresent() && list.get() == listOfWaysHome.get();
        if (!same) {
            list.ifPresent(inForce::add);
        }
        latchedStop.ifPresent(inForce::add);
        return new LogHead(bootId, ledger.entries(), Collections.unmodifiableList(inForce));
    }

    /** What stands at the beginning of a file. */
    static final class LogHead {
        private final String bootId;
        private final List<RememberedCommand> remembered;
        private final List<Sent> inForce;

        private LogHead(String bootId, List<RememberedCommand> remembered, List<Sent> inForce) {
            this.bootId = bootId;
            this.remembered = remembered;
            this.inForce = inForce;
        }

        /** Its lines. */
        String text() {
            StringBuilder text = new StringBuilder(LogLines.begins(bootId, remembered.size() + inForce.size()));
            for (RememberedCommand command : remembered) {
                text.append(LogLines.remembered(bootId, command));
            }
            for (Sent sent : inForce) {
                text.append(LogLines.inForce(bootId, sent.clientId, sent.command));
            }
            return text.toString();
        }
    }
}
