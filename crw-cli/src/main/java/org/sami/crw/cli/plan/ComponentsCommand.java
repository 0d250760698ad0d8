package org.sami.crw.cli.plan;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Interaction;
import org.sami.spn.component.Interactions;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.Purpose;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.NearMatches;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw components}: with what windows show or ask an event's values, and why (thesis 5.2.4). */
@Command(
        name = "components",
        mixinStandardHelpOptions = true,
        description = {
            "Lists the components with which windows ask the operator for an event's values, or show them, and why.",
            "Rates each component for the type and the markup. Without an event or type, lists the components."
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw components",
            "  crw components OperatorSelectBoatList --markup Sort.method=ALPHABETICAL --markup Filter",
            "  crw components --type \"map<proxy,path>\" --markup RelevantInformation",
            "  crw components --type area --create"
        })
public final class ComponentsCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "EVENT", arity = "0..1", description = "An event type, by name or other name.")
    private @Nullable String event;

    @Option(
            names = "--type",
            paramLabel = "TYPE",
            description = "A type of values instead of an event: point, list<point>, map<proxy,path>, Allocation.")
    private @Nullable String type;

    @Option(names = "--create", description = "With --type: the operator gives such a value; else one is shown.")
    private boolean create;

    @Option(
            names = "--markup",
            paramLabel = "MARKUP",
            description = "A markup that the event carries: Sort, Sort.method or Sort.method=ALPHABETICAL. Repeatable.")
    private List<String> markups = new ArrayList<>();

    @Override
    public Integer call() {
        if (event != null && type != null) {
            throw new UsageFault("an event or --type, not both");
        }
        if (create && type == null) {
            throw new UsageFault("--create says something only with --type");
        }
        DomainLibrary library = PlanSource.library();
        PrintWriter out = spec.commandLine().getOut();
        String asked = event == null ? type : event;
        if (asked == null) {
            if (!markups.isEmpty()) {
                throw new UsageFault("--markup says something only with an event or --type");
            }
            library.components().components().forEach(component -> out.print(ComponentText.of(component)));
            library.components().widgets().forEach(widget -> out.print(ComponentText.of(widget)));
        } else {
            Vocabulary vocabulary = library.vocabulary();
            ComponentChoice choice = new ComponentChoice(library.components(), vocabulary.types());
            out.print(new ComponentText(choice).of(asked, interaction(asked, vocabulary)));
        }
        out.flush();
        return ExitCode.OK;
    }

    private Interaction interaction(String asked, Vocabulary vocabulary) {
        List<MarkupOption> options =
                markups.stream().map(text -> markup(vocabulary, text)).toList();
        if (type != null) {
            ValueType value = TypeNames.parse(asked)
                    .orElseThrow(() -> new UsageFault("'" + asked + "' is no type; types are such as "
                            + String.join(", ", TypeNames.builtIn()) + ", list<point>, map<proxy,path>"));
            return new Interaction(
                    create ? Purpose.CREATE : Purpose.SELECT, Map.of(Interactions.ANSWER, value), options);
        }
        EventType found = vocabulary
                .event(asked)
                .orElseThrow(() -> VocabularyText.nothing("event", asked, NearMatches.ofEvents(vocabulary, asked)));
        Optional<Interaction> interaction = new Interactions(vocabulary).of(found, List.of());
        return interaction
                .map(of -> new Interaction(of.purpose(), of.values(), options))
                .orElseThrow(() -> new UsageFault(found.name()
                        + (found.decision().isPresent()
                                ? " asks for variables of the plan; name their types with --type"
                                : " has nothing to show")));
    }

    private static MarkupOption markup(Vocabulary vocabulary, String text) {
        MarkupOption option = MarkupOption.parse(text)
                .orElseThrow(() -> new UsageFault(
                        "--markup '" + text + "' is not such as Sort, Sort.method or Sort.method=ALPHABETICAL"));
        String name = vocabulary.markup(option.markup()).map(MarkupType::name).orElse(option.markup());
        MarkupOption named = new MarkupOption(name, option.option(), option.value());
        named.unknownIn(vocabulary).ifPresent(words -> {
            throw new UsageFault("--markup " + text + ": " + words);
        });
        return named;
    }
}
