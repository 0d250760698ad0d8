package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

class ValueJsonTest {
    private static final int ROUNDS = 5_000;

    @Test
    void everyValueComesBackFromTheFormForFiles() {
        RandomValues random = new RandomValues(1);
        for (int i = 0; i < ROUNDS; i++) {
            ValueType type = random.type(3);
            Value value = random.value(type);

            String text = JsonText.text(ValueJson.write(value, type, RandomValues.TYPES));

            Reading<Value> reading = ValueJson.read(text, type, RandomValues.TYPES);
            assertThat(reading.findings()).as(text).isEmpty();
            assertThat(reading.orThrow()).isEqualTo(value);
        }
    }

    @Test
    void everyValueComesBackFromTheFormThatSaysItsType() throws Exception {
        RandomValues random = new RandomValues(2);
        for (int i = 0; i < ROUNDS; i++) {
            Value value = random.value(random.type(3));

            JsonNode node = JsonText.MAPPER.readTree(JsonText.text(ValueJson.tagged(value)));

            assertThat(ValueJson.fromTagged(node).orThrow()).isEqualTo(value);
        }
    }

    @Test
    void wholeNumberInARealFieldIsARealNumber() {
        Reading<Value> reading = ValueJson.read("3", ValueType.Simple.REAL, RandomValues.TYPES);

        assertThat(reading.orThrow()).isEqualTo(new RealValue(3));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    real               | "3"                                   |              | E-WRONG-TYPE
                    real               | 1e999                                 |              | E-WRONG-TYPE
                    integer            | 3.0                                   |              | E-WRONG-TYPE
                    integer            | 9223372036854775808                   |              | E-WRONG-TYPE
                    boolean            | 0                                     |              | E-WRONG-TYPE
                    text               | null                                  |              | E-WRONG-TYPE
                    duration           | 10                                    |              | E-WRONG-TYPE
                    duration           | "10sec"                                 |              | E-BAD-VALUE
                    duration           | "PT-1S"                               |              | E-BAD-VALUE
                    duration           | "PT0.0001S"                           |              | E-BAD-VALUE
                    duration           | "PT9999999999999999999H"              |              | E-BAD-VALUE
                    point              | {"lat":1}                             |              | E-MISSING-MEMBER
                    point              | {"lat":91,"lon":0}                    |              | E-BAD-VALUE
                    point              | {"lat":1,"lon":2,"lng":3}             | /lng         | E-UNKNOWN-MEMBER
                    point              | [1,2]                                 |              | E-WRONG-TYPE
                    path               | [{"lat":1,"lon":2},{"lat":1,"lon":""}]| /1/lon       | E-WRONG-TYPE
                    area               | {"outline":[]}                        |              | E-BAD-VALUE
                    variable           | "x"                                   |              | E-VARIABLE-NAME
                    list<integer>      | [1,2,"x"]                             | /2           | E-WRONG-TYPE
                    map<proxy,real>    | {"a/b":"x"}                           | /a~1b        | E-WRONG-TYPE
                    map<real,real>     | {"a":1}                               |              | E-WRONG-TYPE
                    map<real,real>     | [[1,2],[1,3]]                         | /1           | E-DUPLICATE
                    map<real,real>     | [[1,2,3]]                             | /0           | E-WRONG-TYPE
                    task               | {"mission":"1","name":"a"}            |              | E-WRONG-TYPE
                    Colour             | "BLUE"                                |              | E-UNKNOWN-WORD
                    Pair               | {"left":1}                            |              | E-MISSING-MEMBER
                    Pair               | {"left":1,"right":[],"up":1}          | /up          | E-UNKNOWN-MEMBER
                    Nothing            | 1                                     |              | E-UNKNOWN-TYPE
                    any                | {"colour":"RED"}                      | /colour      | E-UNKNOWN-TYPE
                    any                | 1                                     |              | E-WRONG-TYPE
                    any                | {"list":[{"real":"x"}]}               | /list/0/real | E-WRONG-TYPE
                    """)
    void mismatchIsAFindingAtItsPlace(String type, String text, String pointer, String code) {
        Reading<Value> reading = ValueJson.read(text, TypeNames.parse(type).orElseThrow(), RandomValues.TYPES);

        assertThat(reading.result()).isEmpty();
        assertThat(reading.findings())
                .extracting(Finding::code, Finding::pointer)
                .contains(org.assertj.core.groups.Tuple.tuple(code, pointer == null ? "" : pointer));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    real
                    list<point>
                    map<proxy,list<path>>
                    map<map<text,real>,Allocation>
                    """)
    void typeComesBackFromItsText(String text) {
        assertThat(TypeNames.of(TypeNames.parse(text).orElseThrow())).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = "''\nlist\nlist<>\nmap<text>\nnumber\nlist<point\nREAL<x>\nmap<,>")
    void textThatIsNoTypeIsRefused(String text) {
        assertThat(TypeNames.parse(text)).isEmpty();
    }
}
