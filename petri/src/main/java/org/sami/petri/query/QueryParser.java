package org.sami.petri.query;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
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
 *           | "deadlock" ["unless" condition] | "bound" name
 * condition = conjunction {"or" conjunction}
 * conjunction = part {"and" part}
 * part      = "not" part | "(" condition ")" | "deadlock" | "enabled" "(" name ")" | "true" | "false" | sum relation sum
 * sum       = ["-"] term {("+" | "-") term}
 * term      = number ["*" tokens] | tokens
 * tokens    = "m" "(" name ")"
 * relation  = "=" | "!=" | "&lt;" | "&lt;=" | "&gt;" | "&gt;="
 * </pre>
 *
 * A name is the id of a place or transition, in double quotes where it has other signs than letters, digits and {@code _.:}. For one thread, once.
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
    private final QueryWords words;
    private int depth;

    /** A sum of tokens and a number. */
    private static final class Sum {
        private final Map<Integer, Long> factors = new TreeMap<>();
        private long constant;
    }

    private QueryParser(PetriNet net, QueryWords words) {
        this.net = net;
        this.words = words;
    }

    /**
     * Reads a query about a net.
     *
     * @throws QueryFaultException with the column at which the text stops making sense, also where the net has no node of a name
     */
    public static NetQuery query(PetriNet net, String text) throws QueryFaultException {
        QueryParser parser = new QueryParser(net, new QueryWords(text));
        NetQuery query = parser.query();
        parser.end();
        return query;
    }

    /** Reads a condition alone. */
    public static MarkingCondition condition(PetriNet net, String text) throws QueryFaultException {
        QueryParser parser = new QueryParser(net, new QueryWords(text));
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
            case "deadlock" -> new NetQuery.Deadlock(words.skip("unless") ? condition() : new Any(List.of()));
            case "bound" -> new NetQuery.Bound(place(words.next()));
            default ->
                throw new QueryFaultException(
                        kind.column(),
                        "a query begins with reachable, invariant, home, deadlock or bound, not with " + kind.shown());
        };
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
            part = new NothingEnabled(net);
        } else if (words.skip("enabled")) {
            words.expect("(");
            part = new Enabled(net, transition(words.next()));
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
        List<Term> terms = new ArrayList<>();
        for (Map.Entry<Integer, Long> entry : left.factors.entrySet()) {
            long factor = entry.getValue();
            if (Math.abs(factor) > Integer.MAX_VALUE) {
                throw new QueryFaultException(column, "the factor " + factor + " is too large");
            }
            if (factor != 0) {
                terms.add(new Term(entry.getKey(), (int) factor));
            }
        }
        return new LinearComparison(terms, relation, right.constant - left.constant);
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
                sum.factors.merge(tokens(), sign * number, Long::sum);
            } else {
                sum.constant += sign * number;
            }
        } else if (word.is("m")) {
            sum.factors.merge(tokens(), (long) sign, Long::sum);
        } else {
            throw new QueryFaultException(
                    word.column(), "expected is a number or the tokens of a place, m(NAME), not " + word.shown());
        }
    }

    private int tokens() throws QueryFaultException {
        words.expect("(");
        int place = place(words.next());
        words.expect(")");
        return place;
    }

    private static long number(QueryWords.Word word) throws QueryFaultException {
        if (word.text().length() > 10 || Long.parseLong(word.text()) > Integer.MAX_VALUE) {
            throw new QueryFaultException(word.column(), "numbers are at most " + Integer.MAX_VALUE);
        }
        return Long.parseLong(word.text());
    }

    private int place(QueryWords.Word name) throws QueryFaultException {
        return known(net.place(name.text()), "place", name);
    }

    private int transition(QueryWords.Word name) throws QueryFaultException {
        return known(net.transition(name.text()), "transition", name);
    }

    private static int known(OptionalInt node, String kind, QueryWords.Word name) throws QueryFaultException {
        if (node.isEmpty()) {
            throw new QueryFaultException(name.column(), "the net has no " + kind + " with the id " + name.shown());
        }
        return node.getAsInt();
    }
}
