package org.sami.crw.cli.plan;

import java.util.concurrent.Callable;
import org.sami.crw.cli.option.PlanSource;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw events}: the events that plans may use. */
@Command(
        name = "events",
        mixinStandardHelpOptions = true,
        description = "Lists the output and input events that plans may use: their other names, fields and answers.",
        footerHeading = "%nExamples:%n",
        footer = {"  crw events", "  crw events battery", "  crw events --json"})
public final class EventsCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private VocabularyQuery query = new VocabularyQuery();

    @Override
    public Integer call() {
        return query.print(
                VocabularyEntries.events(PlanSource.library().vocabulary()),
                spec.commandLine().getOut());
    }
}
