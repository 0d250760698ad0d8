package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BatteryDefaults;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.server.BoatServerDefaults;
import org.sami.crw.operator.alarm.AlarmLimits;
import org.sami.crw.proxy.execution.CommandDefaults;
import org.sami.crw.proxy.link.BaseDefaults;
import org.sami.crw.session.SessionDefaults;
import org.sami.crw.session.fault.HealthDefaults;

/** {@code crw defaults}, and the page that has its tables. */
class DefaultsCommandTest {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/crw/cli/defaults/FleetValues.java");
    private static final Path PAGE = Path.of("../docs/defaults.md");

    private static List<JsonNode> rows(String... arguments) throws Exception {
        CommandResult ran = CommandResult.crw(arguments);
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        List<JsonNode> rows = new ArrayList<>();
        new ObjectMapper().readTree(ran.out()).forEach(rows::add);
        return rows;
    }

    @ParameterizedTest
    @ValueSource(
            classes = {
                LinkDefaults.class,
                MotionDefaults.class,
                BatteryDefaults.class,
                BoatServerDefaults.class,
                BaseDefaults.class,
                CommandDefaults.class,
                AlarmLimits.class,
                SessionDefaults.class,
                HealthDefaults.class
            })
    void eachConstantOfTheDefaultsIsListed(Class<?> room) throws Exception {
        String listed = Files.readString(SOURCES);

        assertThat(room.getFields()).isNotEmpty();
        assertThat(List.of(room.getFields()).stream().map(Field::getName))
                .allSatisfy(constant -> assertThat(listed).contains(room.getSimpleName() + "." + constant));
    }

    @Test
    void eachRowSaysItsValueItsUnitAndWhereItIsSet() throws Exception {
        JsonNode lost = rows("defaults", "link lost", "--json").get(0);

        assertThat(Double.parseDouble(lost.get("value").textValue()) * 1000).isEqualTo(LinkDefaults.LINK_LOST_AFTER_MS);
        assertThat(lost.get("unit").textValue()).isEqualTo("s");
        assertThat(lost.get("setBy").textValue()).isEqualTo("nowhere");
        assertThat(rows("defaults", "--json"))
                .hasSizeGreaterThan(100)
                .allSatisfy(row -> assertThat(row.get("meaning").textValue()).endsWith("."));
    }

    @Test
    void fieldsAndOptionsHaveTheDefaultsOfTheirPlaces() throws Exception {
        JsonNode clearance = rows("defaults", "PathRequest.clearance", "--json").get(0);
        JsonNode answer = rows("defaults", "answer-after", "--json").get(0);
        JsonNode timer =
                rows("defaults", "MixedInitiativeTrigger.timeout", "--json").get(0);

        assertThat(clearance.get("value").textValue()).isEqualTo("5");
        assertThat(clearance.get("setBy").textValue()).isEqualTo("plan");
        assertThat(answer.get("value").textValue()).isEqualTo("5");
        assertThat(answer.get("unit").textValue()).isEqualTo("s");
        assertThat(answer.get("meaning").textValue()).doesNotContain("default");
        assertThat(answer.get("setBy").textValue()).isEqualTo("crw run, crw experiment");
        assertThat(timer.get("value").textValue()).isEmpty();
    }

    @Test
    void aDefaultThatIsSaidInAnOptionsWordsIsListed() throws Exception {
        assertThat(rows("defaults", "Simulated seconds in one second", "--json")
                        .get(0)
                        .get("value")
                        .textValue())
                .isEqualTo("20");
    }

    @Test
    void aWordChoosesThoseThatHaveIt() {
        CommandResult ran = CommandResult.crw("defaults", "Battery");

        assertThat(ran.out())
                .contains("battery low", "30 %", "battery critical", "15 %")
                .doesNotContain("heartbeat");
    }

    @Test
    void aWordThatNoDefaultHasIsAFaultOfTheCommandLine() {
        CommandResult ran = CommandResult.crw("defaults", "zeppelin");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("no default has 'zeppelin'");
        assertThat(CommandResult.crw("defaults", "--json", "--markdown").exitCode())
                .isEqualTo(2);
    }

    /** Put right by {@code crw defaults --markdown}, below the first lines of the page. */
    @Test
    void thePageHasTheTablesThatTheCommandPrints() throws Exception {
        String page = Files.readString(PAGE);

        assertThat(page.substring(page.indexOf("\n## ") + 1))
                .isEqualTo(CommandResult.crw("defaults", "--markdown").out());
    }
}
