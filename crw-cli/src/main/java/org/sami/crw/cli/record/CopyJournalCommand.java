package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalCopy;
import org.sami.spn.journal.JournalReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw copy-journal}: a journal from a file to a database and back. */
@Command(
        name = "copy-journal",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description =
                "Copies a journal from a file to a PostgreSQL database or back: plans, entries, marks, snapshots and"
                        + " telemetry. The copy has the same checksum; the journal itself is only read.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:copied",
            "2:wrong usage, there is no such journal, or one is at the other place",
            "4:the journal cannot be read, or the copy not be written"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw copy-journal today.journal postgresql://localhost/boats?user=pilot",
            "  crw copy-journal postgresql://localhost/boats?user=pilot today-copy.journal"
        })
public final class CopyJournalCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "FROM",
            converter = JournalConverter.class,
            description = "A journal: a file, or postgresql://HOST:PORT/DATABASE.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private JournalAddress from;

    @Parameters(
            index = "1",
            paramLabel = "TO",
            converter = JournalConverter.class,
            description = "Where the copy goes; there must be no journal yet.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private JournalAddress to;

    @Override
    public Integer call() throws IOException {
        if (!from.exists()) {
            throw new UsageFault("there is no journal " + from);
        }
        if (to.file().isPresent() ? Files.exists(to.file().get()) : to.exists()) {
            throw new UsageFault(to + " is there already; choose another place");
        }
        try (JournalReader reader = from.read()) {
            PrintWriter err = spec.commandLine().getErr();
            reader.recovery().damage().ifPresent(damage -> err.println("crw: " + damage));
            err.flush();
            String checksum = JournalCopy.copy(reader, to);
            PrintWriter out = spec.commandLine().getOut();
            out.printf("%s: %d entries copied to %s, checksum %s%n", from, reader.lastIndex(), to, checksum);
            out.flush();
        }
        return ExitCode.OK;
    }
}
