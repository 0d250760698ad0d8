package org.sami.spn.journal;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;

/** A connection to a journal's file that is cut once some entries were read to be applied; those that are read to find the journal's end are not counted. */
final class CutWhileRead {
    private static final String APPLIED = "WHERE idx > ? AND idx <= ?";

    private int left;

    private CutWhileRead(int entries) {
        left = entries;
    }

    static Connection after(int entries, JournalAddress address) throws SQLException {
        CutWhileRead cut = new CutWhileRead(entries);
        return cut.around(Connection.class, DriverManager.getConnection("jdbc:sqlite:" + address));
    }

    private <T> T around(Class<T> kind, T real) {
        return kind.cast(Proxy.newProxyInstance(
                CutWhileRead.class.getClassLoader(),
                new Class<?>[] {kind},
                (proxy, method, arguments) -> called(real, method, arguments)));
    }

    private Object called(Object real, Method method, Object[] arguments) throws Throwable {
        if (real instanceof ResultSet && method.getName().equals("next") && left-- == 0) {
            throw new SQLException("the connection was cut");
        }
        Object made;
        try {
            made = method.invoke(real, arguments);
        } catch (InvocationTargetException fault) {
            throw fault.getCause();
        }
        if (made instanceof PreparedStatement statement
                && arguments[0].toString().contains(APPLIED)) {
            return around(PreparedStatement.class, statement);
        }
        return real instanceof PreparedStatement && made instanceof ResultSet rows
                ? around(ResultSet.class, rows)
                : made;
    }
}
