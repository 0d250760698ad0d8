package org.sami.crw.cli.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.sami.spn.advice.FindingAdvice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;

/** Findings as lines for people and as JSON for programs. */
public final class FindingsText {
    private FindingsText() {}

    /** One line each: file, line and column as compilers print them, severity, code, place in the document, elements, message. */
    public static void print(PrintWriter out, String source, List<Finding> findings) {
        for (Finding finding : findings) {
            out.printf(
                    Locale.ROOT,
                    "%s: %s %s at %s%s: %s%n",
                    place(source, finding),
                    word(finding.severity()),
                    finding.code(),
                    finding.pointer().isEmpty() ? "the top" : finding.pointer(),
                    finding.elements().isEmpty() ? "" : " (" + String.join(", ", finding.elements()) + ")",
                    finding.message());
        }
    }

    /** Below each finding, indented, why it matters, how it is mended, and which edits mend it in an editor. */
    public static void printExplained(PrintWriter out, String source, List<Finding> findings) {
        for (Finding finding : findings) {
            print(out, source, List.of(finding));
            FindingAdvice.of(finding).ifPresent(advice -> {
                out.println("    why: " + advice.why());
                out.println("    mend: " + advice.mend());
            });
            finding.fixes().forEach(fix -> out.println("    fix in DREAMM: " + fix.label()));
        }
    }

    private static String place(String source, Finding finding) {
        return finding.location()
                .map(at -> at.file().isEmpty() ? source + ":" + at : at.toString())
                .orElse(source);
    }

    public static ObjectNode json(String source, List<Finding> findings) {
        ObjectNode json = JsonNodeFactory.instance.objectNode();
        json.put("source", source);
        json.put("errors", count(findings, Severity.ERROR));
        json.put("warnings", count(findings, Severity.WARNING));
        ArrayNode list = json.putArray("findings");
        for (Finding finding : findings) {
            ObjectNode node = list.addObject();
            node.put("severity", word(finding.severity()));
            node.put("code", finding.code());
            node.put("pointer", finding.pointer());
            finding.location().ifPresent(at -> {
                node.put("file", at.file());
                node.put("line", at.line());
                node.put("column", at.column());
            });
            node.put("message", finding.message());
            FindingAdvice.of(finding).ifPresent(advice -> {
                node.put("why", advice.why());
                node.put("mend", advice.mend());
            });
            ArrayNode elements = node.putArray("elements");
            finding.elements().forEach(elements::add);
            node.put("plan", finding.plan());
            ArrayNode fixes = node.putArray("fixes");
            finding.fixes().forEach(fix -> fixes.add(fix.label()));
        }
        return json;
    }

    public static long count(List<Finding> findings, Severity severity) {
        return findings.stream().filter(f -> f.severity() == severity).count();
    }

    private static String word(Severity severity) {
        return severity.name().toLowerCase(Locale.ROOT);
    }
}
