package org.sami.petri.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

class QueryParserTest {
    private final PetriNet net = net();

    private static PetriNet net() {
        PetriNetBuilder net = new PetriNetBuilder("n");
        net.place("p", 0);
        net.place("q.1", 0);
        net.place("At \"home\"", 0);
        int t = net.transition("t");
        net.consume(t, 0, 2);
        return net.build();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        m(p) >= 2 | true
        m(p) > 2 | false
        m(p) = 2 and m(q.1) = 3 | true
        m(p) = 3 or m(q.1) = 3 | true
        not m(p) = 2 | false
        not (m(p) = 2 and m(q.1) != 3) | true
        m(p) + m(q.1) = 5 | true
        2*m(p) - m(q.1) <= 1 | true
        m(p) < m(q.1) | true
        -m(p) + 10 >= 8 | true
        1 = 1 | true
        m(p) - m(p) != 0 | false
        true and not false | true
        enabled(t) and not deadlock | true
        m("At \\"home\\"") = 7 | true
        m(p)=1 or m(p)=2 and m(q.1)=4 | false
        """)
    void conditionsMeanWhatTheySay(String text, boolean expected) throws QueryFaultException {
        assertThat(QueryParser.condition(net, text).test(new int[] {2, 3, 7})).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        reach m(p) = 1 | 1 | a query begins with reachable, invariant, home, deadlock or bound, not with 'reach'
        reachable m(x) = 1 | 13 | the net has no place with the id 'x'
        reachable m(p = 1 | 15 | expected is ')', not '='
        reachable m(p) 1 | 16 | expected is a comparison (=, !=, <, <=, > or >=), not '1'
        reachable m(p) = | 17 | expected is a number or the tokens of a place, m(NAME), not the end
        reachable m(p) = 1 and | 23 | expected is a number or the tokens of a place, m(NAME), not the end
        reachable (m(p) = 1 | 20 | expected is ')', not the end
        reachable m(p) = 1) | 19 | the query should end before ')'
        reachable m(p) = 3000000000 | 18 | numbers are at most 2147483647
        reachable enabled(p) | 19 | the net has no transition with the id 'p'
        reachable m(p) ~ 1 | 16 | '~' has no meaning here; names with such signs stand in "quotes"
        bound "p | 7 | the quotation that begins here has no end
        bound | 6 | expected is a name, not the end
        deadlock if m(p) = 1 | 10 | the query should end before 'if'
        """)
    void faultsSayColumnAndReason(String text, int column, String message) {
        QueryFaultException fault = catchThrowableOfType(QueryFaultException.class, () -> QueryParser.query(net, text));

        assertThat(fault.getMessage()).isEqualTo(message);
        assertThat(fault.column()).isEqualTo(column);
    }

    @Test
    void veryDeepNestingIsRefused() {
        String deep = "reachable " + "(".repeat(100_000) + "true" + ")".repeat(100_000);

        QueryFaultException fault = catchThrowableOfType(QueryFaultException.class, () -> QueryParser.query(net, deep));

        assertThat(fault.getMessage()).isEqualTo("this is nested deeper than 200");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        reachable 2147483647*m(p) + 2147483647*m(q.1) + 2147483647*m("At \\"home\\"") >= 1 | 11
        reachable m(p) = 0 and 2147483647*m(p) + 2147483647*m(q.1) >= 5*m("At \\"home\\"") | 24
        bound 2147483647*m(p) + 2147483647*m(q.1) - 5*m("At \\"home\\"") | 7
        """)
    void sumThatCouldExceedALongIsRefused(String text, int column) {
        QueryFaultException fault = catchThrowableOfType(QueryFaultException.class, () -> QueryParser.query(net, text));

        assertThat(fault).isNotNull();
        assertThat(fault.getMessage()).isEqualTo("the factors are too large: the sum could exceed 9223372036854775807");
        assertThat(fault.column()).isEqualTo(column);
    }

    @Test
    void largestSumThatFitsALongIsReadAndRight() throws QueryFaultException {
        String sum = "2147483647*m(p) + 2147483647*m(q.1) + 4*m(\"At \\\"home\\\"\")";
        int[] marking = {Integer.MAX_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE};

        assertThat(QueryParser.condition(net, sum + " >= 1").test(marking)).isTrue();
        assertThat(((NetQuery.BoundOfSum) QueryParser.query(net, "bound " + sum)).of(marking))
                .isEqualTo(4294967298L * Integer.MAX_VALUE);
    }
}
