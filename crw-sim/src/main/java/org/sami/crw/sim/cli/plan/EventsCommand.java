package org.sami.crw.sim.cli.plan;

import java.util.List;
import java.util.concurrent.Callable;
import org.sami.crw.sim.cli.option.PlanSource;
import org.sami.crw.sim.cli.output.ExitCode;
import org.sami.spn.json.NearMatches;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;
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
    private CommandSpec spec;

    @Mixin
    private VocabularyQuery query = new VocabularyQuery();

    @Override
    public Integer call() {
        Vocabulary vocabulary = PlanSource.library().vocabulary();
        List<EventType> events = vocabulary.events().values().stream()
                .filter(event -> query.isWanted(event.name(), event.aliases()))
                .toList();
        if (events.isEmpty()) {
            throw VocabularyText.nothing("event", query.wanted(), NearMatches.ofEvents(vocabulary, query.wanted()));
        }
        VocabularyText text = new VocabularyText(vocabulary);
        VocabularyWriter writer = new VocabularyWriter(vocabulary);
        query.print(spec.commandLine().getOut(), events, text::of, writer::event);
        return ExitCode.OK;
    }
}
