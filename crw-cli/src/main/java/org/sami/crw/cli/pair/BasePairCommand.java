package org.sami.crw.cli.pair;

import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;

/** {@code crw pair}: two bases, of which one goes on with the session of the other. */
@Command(
        name = "pair",
        mixinStandardHelpOptions = true,
        synopsisSubcommandLabel = "COMMAND",
        subcommands = {
            InitPairCommand.class,
            JoinPairCommand.class,
            PairStatusCommand.class,
            MovePairCommand.class,
            GoAloneCommand.class,
            RejoinPairCommand.class,
            StopPairCommand.class,
            LeavePairCommand.class
        },
        description = {
            "Sets up two bases with a PostgreSQL each, of which one replicates the session of the other and goes on"
                    + " with it when that base is lost (docs/scale.md).",
            "Both need PostgreSQL 15 or later, of one version: sudo apt install postgresql"
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done",
            "2:wrong usage, or what was asked is to be confirmed",
            "4:there is no pair, PostgreSQL is not installed or refuses, or the other base does not answer"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw pair init 10.0.0.6               on the first base; 10.0.0.6 is the second",
            "  crw pair join sami-pair.invitation   on the second, with the file that the first wrote",
            "  crw serve --pair                     on both: the first has the session, the second stands by",
            "  crw pair status",
            "  crw pair address 10.0.1.6            on both, in another network: 10.0.1.6 is the other one now",
            "  crw take-over                        on the second, if it is to go on with the session now",
            "  crw pair rejoin                      on the first, once it was replaced: it stands by then"
        })
public final class BasePairCommand implements Runnable {
    @Override
    public void run() {
        throw new UsageFault("Which command? One of init, join, status, address, alone, rejoin, stop, leave.");
    }
}
