package org.sami.boat.hull.settings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HullFileTest {
    @TempDir
    private Path folder;

    @Test
    void whatIsWrittenIsRead() throws Exception {
        HullSettings hull = HullSettings.of(HullKind.RUDDER)
                .safeMaximum(0.6)
                .trim(-0.1)
                .leftReversed(true)
                .rudderReversed(false)
                .steeringThrust(0.3)
                .turnRateRadPerS(0.8)
                .metresPerPercent(180)
                .cruiseMps(1.8)
                .turningRadiusM(2.5)
                .battery(new BatteryCurve(new double[] {10, 11, 12.6}, new double[] {0, 40, 100}))
                .motorsChecked(true)
                .build();
        Path file = folder.resolve("hull.json");

        HullFile.write(file, hull);
        HullFile.write(file, hull);

        assertThat(HullFile.text(HullFile.read(file))).isEqualTo(HullFile.text(hull));
        assertThat(folder).isDirectoryContaining(path -> path.equals(file));
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactly(file);
        }
    }

    @Test
    void curveOfItsOwnSaysHowFarAPercentTakesTheBoat() {
        String text = "{\"format\":\"sami-hull-1\",\"kind\":\"differential\",\"cruiseMps\":2,"
                + "\"power\":{\"speedMps\":[0,2],\"percentPerHour\":[4,72]}}";

        HullSettings hull = HullFile.parse(text);

        assertThat(hull.performance().metresPerPercent()).hasValue(100);
        assertThat(HullFile.text(hull)).contains("percentPerHour").doesNotContain("metresPerPercent");
        assertThat(HullFile.text(HullFile.parse(HullFile.text(hull)))).isEqualTo(HullFile.text(hull));
        assertThat(HullFile.text(hull.change().build())).isEqualTo(HullFile.text(hull));
        assertThatThrownBy(() -> HullFile.parse(text.replace("cruiseMps", "metresPerPercent")))
                .hasMessageContaining("/power: the way for a percent follows from it");
    }

    @Test
    void whatIsLeftOutIsAsByDefault() {
        HullSettings hull = HullFile.parse("{\"format\":\"sami-hull-1\",\"kind\":\"differential\"}");

        assertThat(HullFile.text(hull))
                .isEqualTo(HullFile.text(HullSettings.of(HullKind.DIFFERENTIAL).build()));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        'safeMaximum': 1.2             | /safeMaximum: the safe maximum is 0.1 to 1.0, not 1.2
        'safeMaximum': 0.05            | /safeMaximum: the safe maximum is 0.1 to 1.0, not 0.05
        'trim': 'left'                 | /trim: expected is a number, not "left"
        'leftReversed': 1              | /leftReversed: expected is true or false, not 1
        'speed': 3                     | /speed: there is no such setting
        'battery': 'nuclear'           | /battery: there is no battery 'nuclear'; there are lipo-3s, lipo-4s, lifepo4-4s, nimh-10, lead-12v
        'battery': {'volts':[12,'x'],'percent':[0,100]} | /battery/volts/1: expected is a number
        'battery': {'volts':[12,11],'percent':[0,100]}  | /battery: volts and percents rise: 11.0 V, 100.0 %
        'metresPerPercent': 0          | /metresPerPercent: the way for a percent of charge is 0.1 to 10000.0, not 0.0
        'power': {'speedMps':[0,'x'],'percentPerHour':[0,9]} | /power/speedMps/1: expected is a number
        'cruiseMps': 'fast'            | /cruiseMps: expected is a number, not "fast"
        'turningRadiusM': -1           | /turningRadiusM: the turning radius is 0.0 to 100.0, not -1.0
        'turnRateRadPerS': 1e99        | /turnRateRadPerS: the turn rate is 0.05 to 3.0, not 1.0E99
        """)
    void whatIsWrongIsNamedWithItsPlace(String member, String said) {
        String text = "{\"format\":\"sami-hull-1\",\"kind\":\"rudder\"," + member.replace('\'', '"') + "}";

        assertThatThrownBy(() -> HullFile.parse(text)).hasMessage(said);
    }

    /** The schema is for editors; the reader holds the same limits. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        'safeMaximum': 1       | true
        'safeMaximum': 1.01    | false
        'safeMaximum': 0.09    | false
        'trim': 0.3            | true
        'trim': -0.31          | false
        'steeringThrust': 0.5  | true
        'steeringThrust': 0.51 | false
        'turnRateRadPerS': 3   | true
        'metresPerPercent': 0.1 | true
        'metresPerPercent': 0 | false
        'cruiseMps': 20        | true
        'cruiseMps': 21        | false
        'turningRadiusM': 0    | true
        'turningRadiusM': 101  | false
        'turnRateRadPerS': 3.1 | false
        'motorsChecked': true  | true
        'motorsChecked': 0     | false
        'sail': 1              | false
        'battery': 'nimh-10'   | true
        'battery': 'AA'        | false
        'battery': {'volts':[10,12],'percent':[0,100]} | true
        'battery': {'volts':[10,61],'percent':[0,100]} | false
        'battery': {'volts':[10],'percent':[0]}        | false
        """)
    void schemaAndReaderAgree(String member, boolean good) throws Exception {
        String text = "{\"format\":\"sami-hull-1\",\"kind\":\"rudder\"," + member.replace('\'', '"') + "}";
        ObjectMapper json = new ObjectMapper();
        Schema schema = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(json.readTree(
                        Files.readString(Path.of("src/main/resources/org/sami/schemas/hull-1.schema.json"))));

        assertThat(schema.validate(json.readTree(text)).isEmpty()).isEqualTo(good);
        if (good) {
            assertThat(HullFile.parse(text)).isNotNull();
        } else {
            assertThatThrownBy(() -> HullFile.parse(text)).isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void otherFormatOtherKindAndNoJsonAreRefused() {
        assertThatThrownBy(() -> HullFile.parse("{\"format\":\"sami-hull-9\",\"kind\":\"rudder\"}"))
                .hasMessage("/format: 'sami-hull-9' is not sami-hull-1");
        assertThatThrownBy(() -> HullFile.parse("{\"format\":\"sami-hull-1\",\"kind\":\"sail\"}"))
                .hasMessage("/kind: 'sail' is neither differential nor rudder");
        assertThatThrownBy(() -> HullFile.parse("{\"format\":\"sami-hull-1\"}"))
                .hasMessage("/kind: expected is a text");
        assertThatThrownBy(() -> HullFile.parse("{")).hasMessageStartingWith("no JSON");
        assertThatThrownBy(() -> HullFile.parse("")).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(
                        () -> HullFile.parse("{\"format\":\"sami-hull-1\",\"kind\":\"rudder\",\"trim\":0,\"trim\":0}"))
                .hasMessageStartingWith("no JSON");
    }

    @Test
    void missingAndOversizedFilesAreNamed() throws Exception {
        Path file = folder.resolve("hull.json");
        assertThatThrownBy(() -> HullFile.read(file)).hasMessage("there is no file " + file);

        Files.write(file, new byte[20_000]);
        assertThatThrownBy(() -> HullFile.read(file)).hasMessageContaining("longer than 16384 bytes");
    }
}
