package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** What commands that list a part of the vocabulary are asked: which of it, and in which form. */
final class VocabularyQuery {
    @Parameters(
            paramLabel = "NAME",
            arity = "0..1",
            defaultValue = "",
            description = "Only those with this in their name or one of their other names.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String wanted;

    @Option(names = "--json", description = "Print one JSON array.")
    private boolean json;

    /**
     * Prints the entries that are asked for, as paragraphs or as one array.
     *
     * @throws UsageFault where no entry has such a name
     */
    <T> int print(VocabularyEntries<T> entries, PrintWriter out) {
        List<T> found = entries.all().stream()
                .filter(entry -> entries.names().apply(entry).anyMatch(this::isWanted))
                .toList();
        if (found.isEmpty()) {
            throw VocabularyText.nothing(entries.kind(), wanted, entries.alike().apply(wanted));
        }
        if (json) {
            ArrayNode array = JsonNodeFactory.instance.arrayNode();
            found.forEach(entry -> array.add(entries.node().apply(entry)));
            out.println(array.toPrettyString());
        } else {
            found.forEach(entry -> out.print(entries.text().apply(entry)));
        }
        out.flush();
        return ExitCode.OK;
    }

    /** Whether a name contains what is asked for, in whatever case and without its spaces: no name has any. */
    private boolean isWanted(String name) {
        return name.toLowerCase(Locale.ROOT)
                .contains(wanted.toLowerCase(Locale.ROOT).replace(" ", ""));
    }
}
