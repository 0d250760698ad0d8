package org.sami.crw.sim.cli;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.sami.spn.json.NearMatches;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw markups}: the markups that events of plans may carry. */
@Command(
        name = "markups",
        mixinStandardHelpOptions = true,
        description = "Lists the markups that events of plans may carry: their other names and options.",
        footerHeading = "%nExamples:%n",
        footer = {"  crw markups", "  crw markups priority", "  crw markups --json"})
final class MarkupsCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "NAME",
            arity = "0..1",
            defaultValue = "",
            description = "Only markups with this in their name or one of their other names.")
    private String wanted;

    @Option(names = "--json", description = "Print one JSON array.")
    private boolean json;

    @Override
    public Integer call() {
        Vocabulary vocabulary = PlanSource.library().vocabulary();
        List<MarkupType> markups = vocabulary.markups().values().stream()
                .filter(markup -> VocabularyText.matches(wanted, markup.name(), markup.aliases()))
                .toList();
        if (markups.isEmpty()) {
            throw VocabularyText.nothing("markup", wanted, NearMatches.ofMarkups(vocabulary, wanted));
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            VocabularyWriter writer = new VocabularyWriter(vocabulary);
            ArrayNode array = JsonNodeFactory.instance.arrayNode();
            markups.forEach(markup -> array.add(writer.markup(markup)));
            out.println(array.toPrettyString());
        } else {
            VocabularyText text = new VocabularyText(vocabulary);
            markups.forEach(markup -> out.print(text.of(markup)));
        }
        out.flush();
        return ExitCode.OK;
    }
}
