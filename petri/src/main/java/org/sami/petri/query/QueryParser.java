package org.sami.petri.query;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.LinearComparison.Relation;
import org.sami.petri.query.LinearComparison.Term;
import org.sami.petri.query.MarkingCondition.All;
import org.sami.petri.query.MarkingCondition.Any;
import org.sami.petri.query.MarkingCondition.Enabled;
import org.sami.petri.query.MarkingCondition.Not;
import org.sami.petri.query.MarkingCondition.NothingEnabled;

/**
 * Reads queries:
 *
 * <pre>
 * query     = "reachable" condition | "invariant" condition | "home" condition
 *           | "deadlock" ["unless" condition] | "bound" (name | sum)
 * condition = conjunction {"or" conjunction}
 * conjunction = part {"and" part}
 * part      = "not" part | "(" condition ")" | "deadlock" | "enabled" "(" name ")" | "true" | "false" | sum relation sum
 * sum       = ["-"] term {("+" | "-") term}
 * term      = number ["*" tokens] | tokens
 * tokens    = "m" "(" name ")"
 * relation  = "=" | "!=" | "&lt;" | "&lt;=" | "&gt;" | "&gt;="
 * </pre>
 *
 * A name is the id of a place or transition, in double quotes where it has other signs than letters, digits and {@code _.:-}. Where the net has words of its own
 * ({@link NetNames}), {@code ended} is a condition too. For one thread, once.
 */
public final class QueryParser {
    private static final Map<String, Relation> RELATIONS = Map.of(
            "<", Relation.LESS,
            "<=", Relation.AT_MOST,
            "=", Relation.EQUAL,
            "!=", Relation.NOT_EQUAL,
            ">=", Relation.AT_LEAST,
            ">", Relation.MORE);

    /** Brackets and negations may be nested so deep. */
    private static final int MOST_DEPTH = 200;

    private final PetriNet net;
    private final NetNames names;
    private final QueryWords words;
    private int depth;

    /** A sum of tokens and a number. */
    private static final class Sum {
        private final Map<Integer, Long> factors = new TreeMap<>();
        private long constant;
    }

    private QueryParser(PetriNet net, NetNames names, QueryWords words) {
        this.net = net;
        this.names = names;
        this.words = words;
    }

    /**
     * Reads a query about a net.
     *
     * @throws QueryFaultException with the column at which the text stops making sense, also where the net has no node of a name
     */
    public static NetQuery query(PetriNet net, String text) throws QueryFaultException {
        return query(net, NetNames.of(net), text);
    }

    /**
     * Reads a query in which nodes are called by other names.
     *
     * @throws QueryFaultException with the column at which the text stops making sense, also where a name means nothing
     */
    public static NetQuery query(PetriNet net, NetNames names, String text) throws QueryFaultException {
        QueryParser parser = new QueryParser(net, names, new QueryWords(text));
        NetQuery query = parser.query();
        parser.end();
        return query;
    }

    /** Reads a condition alone. */
    public static MarkingCondition condition(PetriNet net, String text) throws QueryFaultException {
        QueryParser parser = new QueryParser(net, NetNames.of(net), new QueryWords(text));
        MarkingCondition condition = parser.condition();
        parser.end();
        return condition;
    }

    private void end() throws QueryFaultException {
        QueryWords.Word rest = words.peek();
        if (!rest.text().isEmpty() || rest.isQuoted()) {
            throw new QueryFaultException(rest.column(), "the query should end before " + rest.shown());
        }
    }

    private NetQuery query() throws QueryFaultException {
        QueryWords.Word kind = words.next();
        return switch (kind.isQuoted() ? "" : kind.text()) {
            case "reachable" -> new NetQuery.Reachable(condition());
            case "invariant" -> new NetQuery.Invariant(condition());
            case "home" -> new NetQuery.Home(condition());
            case "deadlock" ->
                new NetQuery.Deadlock(words.skip("unless") ? orEnd(condition()) : orEnd(new Any(List.of())));
            case "bound" -> bound();
            default ->
                throw new QueryFaultException(
                        kind.column(),
                        "a query begins with reachable, invariant, home, deadlock or bound, not with " + kind.shown());
        };
    }

    private MarkingCondition orEnd(MarkingCondition condition) {
        return names.end()
                .<MarkingCondition>map(end -> new Any(List.of(condition, end)))
                .orElse(condition);
    }

    /** Of a place, or of a sum. */
    private NetQuery bound() throws QueryFaultException {
        QueryWords.Word first = words.peek();
        if (words.isSum()) {
            Sum sum = sum();
            return new NetQuery.BoundOfSum(terms(sum, sum.constant, first.column()), sum.constant, words.since(first));
        }
        String name = name();
        List<Integer> places = places(name, first);
        return places.size() == 1
                ? new NetQuery.Bound(places.get(0))
                : new NetQuery.BoundOfSum(
                        places.stream().map(place -> new Term(place, 1)).toList(), 0, name);
    }

    private MarkingCondition condition() throws QueryFaultException {
        List<MarkingCondition> parts = new ArrayList<>(List.of(conjunction()));
        while (words.skip("or")) {
            parts.add(conjunction());
        }
        return parts.size() == 1 ? parts.get(0) : new Any(parts);
    }

    private MarkingCondition conjunction() throws QueryFaultException {
        List<MarkingCondition> parts = new ArrayList<>(List.of(part()));
        while (words.skip("and")) {
            parts.add(part());
        }
        return parts.size() == 1 ? parts.get(0) : new All(parts);
    }

    private MarkingCondition part() throws QueryFaultException {
        QueryWords.Word first = words.peek();
        if (++depth > MOST_DEPTH) {
            throw new QueryFaultException(first.column(), "this is nested deeper than " + MOST_DEPTH);
        }
        MarkingCondition part;
        if (words.skip("not")) {
            part = new Not(part());
        } else if (words.skip("true")) {
            part = new All(List.of());
        } else if (words.skip("false")) {
            part = new Any(List.of());
        } else if (words.skip("deadlock")) {
            part = names.end()
                    .<MarkingCondition>map(end -> new All(List.of(new NothingEnabled(net), new Not(end))))
                    .orElse(new NothingEnabled(net));
        } else if (names.end().isPresent() && words.skip("ended")) {
            part = names.end().get();
        } else if (names.duplicated().isPresent() && words.skip("duplicated")) {
            part = names.duplicated().get();
        } else if (words.skip("enabled")) {
            words.expect("(");
            part = enabled();
            words.expect(")");
        } else if (words.skip("(")) {
            part = condition();
            words.expect(")");
        } else {
            part = comparison();
        }
        depth--;
        return part;
    }

    private MarkingCondition enabled() throws QueryFaultException {
        QueryWords.Word first = words.peek();
        String name = name();
        List<MarkingCondition> any =
                names.transitions(name).orElseThrow(() -> unknown("transition", name, first)).stream()
                        .<MarkingCondition>map(transition -> new Enabled(net, transition))
                        .toList();
        return any.size() == 1 ? any.get(0) : new Any(any);
    }

    private MarkingCondition comparison() throws QueryFaultException {
        int column = words.peek().column();
        Sum left = sum();
        QueryWords.Word sign = words.next();
        Relation relation = sign.isQuoted() ? null : RELATIONS.get(sign.text());
        if (relation == null) {
            throw new QueryFaultException(
                    sign.column(), "expected is a comparison (=, !=, <, <=, > or >=), not " + sign.shown());
        }
        Sum right = sum();
        right.factors.forEach((place, factor) -> left.factors.merge(place, -factor, Long::sum));
        long constant = right.constant - left.constant;
        return new LinearComparison(terms(left, constant, column), relation, constant);
    }

    /** The terms of a sum; refuses one that, with the constant, could exceed a long in some marking, as the comparison would then be wrong. */
    private static List<Term> terms(Sum sum, long constant, int column) throws QueryFaultException {
        List<Term> terms = new ArrayList<>();
        long factors = 0;
        for (Map.Entry<Integer, Long> entry : sum.factors.entrySet()) {
            long factor = entry.getValue();
            if (Math.abs(factor) > Integer.MAX_VALUE) {
                throw new QueryFaultException(column, "the factor " + factor + " is too large");
            }
            if (factor != 0) {
                terms.add(new Term(entry.getKey(), (int) factor));
                factors += Math.abs(factor);
            }
        }
        if (factors > (Long.MAX_VALUE - Math.abs(constant)) / Integer.MAX_VALUE) {
            throw new QueryFaultException(column, "the factors are too large: the sum could exceed " + Long.MAX_VALUE);
        }
        return terms;
    }

    private Sum sum() throws QueryFaultException {
        Sum sum = new Sum();
        int sign = words.skip("-") ? -1 : 1;
        term(sum, sign);
        while (words.peek().is("+") || words.peek().is("-")) {
            term(sum, words.next().is("-") ? -1 : 1);
        }
        return sum;
    }

    private void term(Sum sum, int sign) throws QueryFaultException {
        QueryWords.Word word = words.next();
        if (!word.isQuoted() && word.text().matches("\\d+")) {
            long number = number(word);
            if (words.skip("*")) {
                words.expect("m");
                tokens(sum, sign * number);
            } else {
                sum.constant += sign * number;
            }
        } else if (word.is("m")) {
            tokens(sum, sign);
        } else {
            throw new QueryFaultException(
                    word.column(), "expected is a number or the tokens of a place, m(NAME), not " + word.shown());
        }
    }

    private void tokens(Sum sum, long factor) throws QueryFaultException {
        words.expect("(");
        QueryWords.Word first = words.peek();
        places(name(), first).forEach(place -> sum.factors.merge(place, factor, Long::sum));
        words.expect(")");
    }

    private static long number(QueryWords.Word word) throws QueryFaultException {
        if (word.text().length() > 10 || Long.parseLong(word.text()) > Integer.MAX_VALUE) {
            throw new QueryFaultException(word.column(), "numbers are at most " + Integer.MAX_VALUE);
        }
        return Long.parseLong(word.text());
    }

    /** A name in brackets or at the end: its signs need no quotes there. */
    private String name() throws QueryFaultException {
        QueryWords.Word first = words.next();
        if (first.is("") || first.is(")")) {
            throw new QueryFaultException(first.column(), "expected is a name, not " + first.shown());
        }
        StringBuilder name = new StringBuilder(first.text());
        boolean isOpen = false; // after a hyphen
        while (isOpen || words.peek().is("-") || isTail(words.peek())) {
            QueryWords.Word part = words.next();
            isOpen = part.is("-");
            name.append(part.text());
        }
        return name.toString();
    }

    /** Whether a word goes on with a name that ended in quotes. */
    private static boolean isTail(QueryWords.Word word) {
        return !word.isQuoted() && word.text().startsWith(".");
    }

    private List<Integer> places(String name, QueryWords.Word at) throws QueryFaultException {
        return names.places(name).orElseThrow(() -> unknown("place", name, at));
    }

    private static QueryFaultException unknown(String kind, String name, QueryWords.Word at) {
        return new QueryFaultException(at.column(), "the net has no " + kind + " with the id '" + name + "'");
    }
}
