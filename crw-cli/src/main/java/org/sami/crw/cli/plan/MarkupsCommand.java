package org.sami.crw.cli.plan;

import java.util.concurrent.Callable;
import org.sami.crw.cli.option.PlanSource;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw markups}: the markups that events of plans may carry. */
@Command(
        name = "markups",
        mixinStandardHelpOptions = true,
        description = "Lists the markups that events of plans may carry: their other names and options.",
        footerHeading = "%nExamples:%n",
        footer = {"  crw markups", "  crw markups priority", "  crw markups --json"})
public final class MarkupsCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private VocabularyQuery query = new VocabularyQuery();

    @Override
    public Integer call() {
        return query.print(
                VocabularyEntries.markups(PlanSource.library().vocabulary()),
                spec.commandLine().getOut());
    }
}
