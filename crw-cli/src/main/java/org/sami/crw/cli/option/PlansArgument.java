package org.sami.crw.cli.option;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** The argument {@code FILE|PLAN} of commands that read plans, with the domain in whose words they are written. */
public final class PlansArgument {
    @Parameters(
            paramLabel = "FILE|PLAN",
            description = "A project's file or folder, or a plan of the library by its id.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    @Mixin
    private DomainOption domain = new DomainOption();

    /**
     * What was read.
     *
     * @param source has a project
     */
    public record Read(DomainLibrary library, PlanSource source) {}

    /** As it was given. */
    public String name() {
        return name;
    }

    /**
     * Reads domain and plans; empty where one of them cannot be read, after its findings were printed.
     *
     * @throws UsageFault if there is no such domain, or no such plan and no such file
     */
    public Optional<Read> read(PrintWriter err) {
        Reading<DomainLibrary> words = domain.read();
        if (words.result().isEmpty()) {
            return unreadable(err, domain.name(), words.findings());
        }
        DomainLibrary library = words.result().get();
        PlanSource source = domain.find(name, library);
        return source.project().isEmpty()
                ? unreadable(err, name, source.findings())
                : Optional.of(new Read(library, source));
    }

    private static Optional<Read> unreadable(PrintWriter err, String source, List<Finding> findings) {
        FindingsText.print(err, source, findings);
        err.flush();
        return Optional.empty();
    }
}
