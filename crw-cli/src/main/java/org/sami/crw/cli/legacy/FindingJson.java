package org.sami.crw.cli.legacy;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import org.sami.spn.advice.FindingAdvice;
import org.sami.spn.finding.Finding;

/** Findings of an import for programs. */
final class FindingJson {
    private FindingJson() {}

    static ObjectNode of(Finding finding) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("severity", finding.severity().name().toLowerCase(Locale.ROOT));
        node.put("code", finding.code());
        node.put("pointer", finding.pointer());
        node.put("message", finding.message());
        FindingAdvice.of(finding).ifPresent(advice -> {
            node.put("why", advice.why());
            node.put("mend", advice.mend());
        });
        ArrayNode elements = node.putArray("elements");
        finding.elements().forEach(elements::add);
        return node;
    }
}
