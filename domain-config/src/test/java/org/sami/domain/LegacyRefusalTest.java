package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.legacy.LegacyImport;

class LegacyRefusalTest extends LegacyImportFixture {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''                                  | E-SYNTAX",
                "{\"format\": \"sami-leg              | E-SYNTAX",
                "[]                                  | E-WRONG-TYPE",
                "{}                                  | E-FORMAT",
                "{\"format\": \"sami\", \"version\": 1}   | E-FORMAT",
                "{\"format\": \"sami-legacy-project\"}  | E-VERSION",
                "{\"format\": \"sami-legacy-project\", \"version\": 2} | E-VERSION",
                "{\"format\": \"sami-legacy-project\", \"version\": \"1\"} | E-WRONG-TYPE",
                "{\"format\": \"sami-legacy-project\", \"version\": 1} | E-MISSING-MEMBER",
                "{\"format\": \"sami-legacy-project\", \"version\": 1, \"plans\": {}} | E-WRONG-TYPE",
                "{\"format\": \"sami-legacy-project\", \"version\": 1, \"plans\": [], \"plans\": []} | E-SYNTAX",
            })
    void aFileThatIsNoExportIsRefused(String text, String code) {
        LegacyImport.Result result = new LegacyImport(VOCABULARY, TABLE).read(text, "bad");

        assertThat(result.project()).isEmpty();
        assertThat(codes(result).get(0)).isEqualTo(code);
    }

    @ParameterizedTest
    @CsvSource({
        "/plans/0/vertices/0, type, road, E-UNKNOWN-WORD",
        "/plans/0/vertices/0, mode, Sleepy, E-UNKNOWN-WORD",
        "/plans/0/vertices/1, key, start, E-DUPLICATE",
        "/plans/0/edges/0, from, nowhere, E-DANGLING",
        "/plans/0/edges/0, type, across, E-UNKNOWN-WORD",
        "/plans/0/edges/0/requirements/0, kind, Sometimes, E-UNKNOWN-WORD",
        "/plans/0/edges/0/requirements/0, match, Most, E-UNKNOWN-WORD",
        "/plans/0/edges/1/requirements/0, action, Lend, E-UNKNOWN-WORD",
        "/plans/0, role, leaf, E-UNKNOWN-WORD",
        "/plans/0, vertices, none, E-WRONG-TYPE",
        "/missionTree/children/0, plan, p9, E-DANGLING",
        "/plans/0/vertices/0/subMissions/0, plan, p9, E-DANGLING",
        "/plans/0/vertices/0/events/0, direction, up, E-UNKNOWN-WORD",
    })
    void aDamagedExportIsRefusedWithThePlaceOfTheDamage(String where, String member, String word, String code) {
        document.plan("p1", "One")
                .place("start", output("sami.event.GetAllProxyTokens", "'declaredFields': []"))
                .runs("p1", false)
                .transition("t")
                .in("start", "t", "None - 0")
                .out("t", "start", "Generic Number 1 Take");
        ((ObjectNode) document.root.at(where)).put(member, word);

        LegacyImport.Result result = new LegacyImport(VOCABULARY, TABLE).read(document.text(), "bad");

        assertThat(result.project()).isEmpty();
        assertThat(result.findings())
                .filteredOn(f -> f.code().equals(code))
                .anySatisfy(f -> assertThat(f.pointer()).isEqualTo(where + "/" + member));
    }

    @Test
    void whatTheFormatDoesNotHaveIsNotLostInSilence() {
        document.plan("p1", "One").place("start").last().put("colour", "red");

        assertThat(result().findings())
                .anySatisfy(f -> assertThat(f.pointer()).isEqualTo("/plans/0/vertices/0/colour"));
    }
}
