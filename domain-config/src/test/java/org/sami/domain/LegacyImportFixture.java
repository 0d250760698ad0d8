package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** Imports an export that a test makes, and holds every import to its accounts and to the format. */
abstract class LegacyImportFixture {
    static final String CRW = "/org/sami/domain/crw";
    static final Vocabulary VOCABULARY = VocabularyReader.fromClassPath(CRW).orThrow();
    static final LegacyTable TABLE =
            LegacyTableReader.fromClassPath(CRW + "/legacy.json", VOCABULARY).orThrow();
    static final String INT_10 = "{'type': 'int', 'class': 'java.lang.Integer', 'value': 10}";

    final LegacyDocument document = new LegacyDocument();

    LegacyImport.Result result() {
        LegacyImport.Result result = new LegacyImport(VOCABULARY, TABLE).read(document.text(), "made");
        assertThat(result.isAccountedFor())
                .as("%s%n%s%n%s", result.source(), result.imported(), result.explained())
                .isTrue();
        result.project()
                .ifPresent(p -> assertThat(new ProjectReader(VOCABULARY)
                                .read(new ProjectWriter(VOCABULARY).text(p))
                                .orThrow())
                        .isEqualTo(p));
        return result;
    }

    Plan plan() {
        return result().project().orElseThrow().plans().get(0);
    }

    static String event(String className, String direction, String members) {
        return "{'class': '" + className + "', 'direction': '" + direction + "', " + members + "}";
    }

    static String output(String className, String members) {
        return event(className, "output", members);
    }

    OutputEventSpec outputOf(String event) {
        document.plan("p1", "One").place("start", event);
        return plan().places().get(0).outputs().get(0);
    }

    static List<String> codes(LegacyImport.Result result) {
        return result.findings().stream().map(Finding::code).toList();
    }
}
