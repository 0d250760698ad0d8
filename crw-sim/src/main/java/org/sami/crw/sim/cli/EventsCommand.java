package org.sami.crw.sim.cli;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.sami.spn.json.NearMatches;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw events}: the events that plans may use. */
@Command(
        name = "events",
        mixinStandardHelpOptions = true,
        description = "Lists the output and input events that plans may use: their other names, fields and answers.",
        footerHeading = "%nExamples:%n",
        footer = {"  crw events", "  crw events battery", "  crw events --json"})
final class EventsCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "NAME",
            arity = "0..1",
            defaultValue = "",
            description = "Only events with this in their name or one of their other names.")
    private String wanted;

    @Option(names = "--json", description = "Print one JSON array.")
    private boolean json;

    @Override
    public Integer call() {
        Vocabulary vocabulary = PlanSource.library().vocabulary();
        List<EventType> events = vocabulary.events().values().stream()
                .filter(event -> VocabularyText.matches(wanted, event.name(), event.aliases()))
                .toList();
        if (events.isEmpty()) {
            throw VocabularyText.nothing("event", wanted, NearMatches.ofEvents(vocabulary, wanted));
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            VocabularyWriter writer = new VocabularyWriter(vocabulary);
            ArrayNode array = JsonNodeFactory.instance.arrayNode();
            events.forEach(event -> array.add(writer.event(event)));
            out.println(array.toPrettyString());
        } else {
            VocabularyText text = new VocabularyText(vocabulary);
            events.forEach(event -> out.print(text.of(event)));
        }
        out.flush();
        return ExitCode.OK;
    }
}
