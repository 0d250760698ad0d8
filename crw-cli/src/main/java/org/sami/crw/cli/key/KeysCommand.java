package org.sami.crw.cli.key;

import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;

/** {@code crw keys}: pairs boats with this base, lists and withdraws keys, takes them to a second laptop. */
@Command(
        name = "keys",
        mixinStandardHelpOptions = true,
        synopsisSubcommandLabel = "COMMAND",
        subcommands = {
            PairCommand.class,
            KeyListCommand.class,
            WithdrawCommand.class,
            FleetKeyCommand.class,
            ExportKeysCommand.class,
            ImportKeysCommand.class
        },
        description = "Pairs boats with this base, and manages the keys by which they know each other.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done",
            "2:wrong usage, or a file that cannot be read",
            "4:the boat does not agree, or is not reached"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw boat --port 5001 --name anna --at 45.4,10.9 --boat-keys anna-keys --pair   the boat shows six words",
            "  crw keys pair 127.0.0.1:5001 --words \"able ...\"   both show the same check code",
            "  crw keys list",
            "  crw keys withdraw 3f2a90bc11d0e5a7   the boats learn it when they are commanded next",
            "  crw keys fleet --give mavlink:serial:/dev/ttyACM0:115200   an ArduPilot vehicle signs from now on",
            "  crw keys export fleet.keys           asks for a password; on the second laptop: crw keys import"
                    + " fleet.keys"
        })
public final class KeysCommand implements Runnable {
    @Override
    public void run() {
        throw new UsageFault("Which command? One of pair, list, withdraw, fleet, export, import.");
    }
}
