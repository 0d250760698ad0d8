package org.sami.crw.sim.cli.plan;

import java.util.List;
import java.util.concurrent.Callable;
import org.sami.crw.sim.cli.option.PlanSource;
import org.sami.crw.sim.cli.output.ExitCode;
import org.sami.spn.json.NearMatches;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;
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
    private CommandSpec spec;

    @Mixin
    private VocabularyQuery query = new VocabularyQuery();

    @Override
    public Integer call() {
        Vocabulary vocabulary = PlanSource.library().vocabulary();
        List<MarkupType> markups = vocabulary.markups().values().stream()
                .filter(markup -> query.isWanted(markup.name(), markup.aliases()))
                .toList();
        if (markups.isEmpty()) {
            throw VocabularyText.nothing("markup", query.wanted(), NearMatches.ofMarkups(vocabulary, query.wanted()));
        }
        VocabularyText text = new VocabularyText(vocabulary);
        VocabularyWriter writer = new VocabularyWriter(vocabulary);
        query.print(spec.commandLine().getOut(), markups, text::of, writer::markup);
        return ExitCode.OK;
    }
}
