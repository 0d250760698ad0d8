package org.sami.crw.sim.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.function.Function;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** What commands that list a part of the vocabulary are asked: which of it, and in which form. */
final class VocabularyQuery {
    @Parameters(
            paramLabel = "NAME",
            arity = "0..1",
            defaultValue = "",
            description = "Only those with this in their name or one of their other names.")
    private String wanted;

    @Option(names = "--json", description = "Print one JSON array.")
    private boolean json;

    /** What is to be in a name; empty for all. */
    String wanted() {
        return wanted;
    }

    /** Whether one of an entry's names is asked for. */
    boolean isWanted(String name, List<String> aliases) {
        return VocabularyText.matches(wanted, name, aliases);
    }

    /** Prints entries, as paragraphs or as one array. */
    <T> void print(PrintWriter out, List<T> entries, Function<T, String> text, Function<T, ObjectNode> node) {
        if (json) {
            ArrayNode array = JsonNodeFactory.instance.arrayNode();
            entries.forEach(entry -> array.add(node.apply(entry)));
            out.println(array.toPrettyString());
        } else {
            entries.forEach(entry -> out.print(text.apply(entry)));
        }
        out.flush();
    }
}
