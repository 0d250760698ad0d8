package org.sami.dreamm.learn;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.lessons.course.TokensAt;
import org.sami.picture.net.NetMarking;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** Tokens that a learner puts into places: generic ones counted, each robot and each task once in a place. */
public final class TokenDraft {
    private static final long NO_MISSION = 0;

    private final Map<String, List<Token>> tokens = new LinkedHashMap<>();

    /** A draft that begins with some tokens. */
    public TokenDraft(List<TokensAt> begin) {
        tokens.putAll(tokens(begin));
    }

    private static Map<String, List<Token>> tokens(List<TokensAt> given) {
        Map<String, List<Token>> tokens = new LinkedHashMap<>();
        for (TokensAt at : given) {
            List<Token> there = tokens.computeIfAbsent(at.place(), place -> new ArrayList<>());
            for (int i = 0; i < at.generic(); i++) {
                there.add(Token.GENERIC);
            }
            at.robots().forEach(robot -> there.add(new Token.Proxy(robot)));
            at.tasks().forEach(task -> there.add(new Token.Task(new TaskId(NO_MISSION, task))));
        }
        return tokens;
    }

    /** What is painted for some tokens. */
    public static NetMarking marking(List<TokensAt> given) {
        return new NetMarking(tokens(given), Set.of(), Map.of());
    }

    /** The tokens of which some tokens are: the generic one, each robot, each task. */
    public static List<Token> kinds(List<TokensAt> given) {
        Set<Token> kinds = new LinkedHashSet<>();
        kinds.add(Token.GENERIC);
        Map<String, List<Token>> all = tokens(given);
        all.values()
                .forEach(there ->
                        there.stream().filter(Token.Proxy.class::isInstance).forEach(kinds::add));
        all.values()
                .forEach(there ->
                        there.stream().filter(Token.Task.class::isInstance).forEach(kinds::add));
        return List.copyOf(kinds);
    }

    /** What a token is called. */
    public static String name(Token token) {
        if (token instanceof Token.Proxy robot) {
            return robot.proxy();
        }
        return token instanceof Token.Task task ? task.task().name() : "generic";
    }

    /** Puts a generic token into a place; a robot or task that stands there already is taken out. */
    public void put(String place, Token token) {
        List<Token> there = tokens.computeIfAbsent(place, each -> new ArrayList<>());
        if (token.equals(Token.GENERIC) || !there.remove(token)) {
            there.add(token);
        }
    }

    /** Takes all tokens out of a place. */
    public void clear(String place) {
        tokens.remove(place);
    }

    /** What stands where. */
    public NetMarking marking() {
        return new NetMarking(tokens, Set.of(), Map.of());
    }

    /** The same as an answer to a quiz says it. */
    public List<TokensAt> tokens() {
        List<TokensAt> all = new ArrayList<>();
        tokens.forEach((place, there) -> all.add(new TokensAt(
                place,
                (int) there.stream().filter(Token.GENERIC::equals).count(),
                names(there, Token.Proxy.class),
                names(there, Token.Task.class))));
        return all.stream().filter(at -> !at.isEmpty()).toList();
    }

    private static List<String> names(List<Token> tokens, Class<? extends Token> kind) {
        return tokens.stream().filter(kind::isInstance).map(TokenDraft::name).toList();
    }
}
